#include "ripstop/io/json/project_tiles.h"

#include <cmath>

#include "ripstop/base/error.h"
#include "ripstop/base/text/number_text.h"
#include "ripstop/base/text/units.h"
#include "ripstop/io/json/json_text.h"
#include "ripstop/io/text/text.h"

namespace ripstop {
namespace {

using nlohmann::json;

void read_warp(const json& value, const std::string& place, ProjectTile& tile) {
    require_known_keys(value, {"direction", "from", "to", "turn_deg"}, place);
    const std::optional<Vec3> direction = point_at(value, "direction", place);
    const std::optional<Vec3> from = point_at(value, "from", place);
    const std::optional<Vec3> to = point_at(value, "to", place);
    const std::optional<double> turn = number_at(value, "turn_deg", place);
    const int ways = direction.has_value() + (from || to) + turn.has_value();
    if (ways != 1 || from.has_value() != to.has_value())
        throw InputError(place +
                         ": expected either \"direction\" alone, or both \"from\" and \"to\", or \"turn_deg\" alone; "
                         "give one of the three");
    if (turn) {
        if (!(std::abs(*turn) <= 360))
            throw InputError(place + ": turn_deg is " + format_shortest(*turn) +
                             ", expected degrees from the longest axis between -360 and 360");
        tile.turn = *turn * degree;
        return;
    }
    const Vec3 warp = direction ? *direction : *to - *from;
    const double length = warp.stableNorm();
    if (!(length > 0) || !std::isfinite(length))
        throw InputError(place + ": the warp has no direction, expected " +
                         (direction ? "a vector other than [0, 0, 0]" : "two different points") + "; correct it");
    tile.warp = warp / length;
}

double compensation_of(const json& value, const std::string& place) {
    if (!value.is_number() || !(value.get<double>() > -50 && value.get<double>() < 100))
        throw InputError(place + ": expected a percentage above -50 and below 100");
    return value.get<double>() * percent;
}

Compensation read_compensation(const json& value, const std::string& place) {
    require_known_keys(value, {"warp_pct", "weft_pct", "chains_pct"}, place);
    Compensation compensation;
    if (value.contains("warp_pct")) compensation.warp = compensation_of(value["warp_pct"], place + ": warp_pct");
    if (value.contains("weft_pct")) compensation.weft = compensation_of(value["weft_pct"], place + ": weft_pct");
    if (value.contains("chains_pct")) {
        if (!value["chains_pct"].is_array())
            throw InputError(place + ": chains_pct is not a list, expected one percentage per chain: [0.2, 0, ...]");
        for (const json& chain : value["chains_pct"])
            compensation.chains.push_back(compensation_of(chain, place + ": chains_pct"));
    }
    return compensation;
}

/// Reads which surface of the file the entry names, if it names one.
void read_surface(const json& value, const std::string& place, ProjectTile& tile) {
    tile.source = text_at(value, "source", place);
    tile.at = point_at(value, "at", place);
    if (!tile.names_a_surface()) return;
    if (tile.source && tile.at)
        throw InputError(place + ": both \"source\" and \"at\" say which surface it is; give one of the two");
    if (tile.source && tile.source->empty())
        throw InputError(place +
                         ": source is empty, expected the name a surface has in the file; give it or leave it out");
    if (tile.name.find_first_of("*?") != std::string::npos)
        throw InputError(place +
                         ": the name of one surface, given by its source or a point, has a * or ? in it, "
                         "expected the name the tile is to have; give it in full");
}

}  // namespace

ProjectTile read_project_tile(const json& value, const std::string& place) {
    require_known_keys(value, {"name", "source", "at", "warp", "corners", "compensation", "fabric"}, place);
    ProjectTile tile;
    tile.name = text_at(value, "name", place).value_or("");
    if (tile.name.empty())
        throw InputError(place + ": no name, expected the tile's name or a pattern such as \"G01*\"; add \"name\"");
    const std::string named = place + " (" + shown(tile.name) + ")";
    read_surface(value, named, tile);
    if (value.contains("warp")) read_warp(value["warp"], named + ": warp", tile);
    if (value.contains("corners")) {
        const json& corners = value["corners"];
        if (!corners.is_array() || corners.empty())
            throw InputError(named + ": corners is empty or not a list, expected points: [[x, y, z], ...]");
        for (std::size_t i = 0; i < corners.size(); ++i)
            tile.corners.push_back(point_of(corners[i], named + ": corner " + std::to_string(i + 1)));
    }
    if (value.contains("compensation"))
        tile.compensation = read_compensation(value["compensation"], named + ": compensation");
    tile.fabric = text_at(value, "fabric", named);
    return tile;
}

}  // namespace ripstop
