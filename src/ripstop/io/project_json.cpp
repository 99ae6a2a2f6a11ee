#include "ripstop/io/project_json.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "ripstop/base/error.h"
#include "ripstop/base/glob.h"
#include "ripstop/base/number_text.h"
#include "ripstop/base/units.h"
#include "ripstop/io/json_text.h"
#include "ripstop/io/text.h"

namespace ripstop {
namespace {

using nlohmann::json;

Vec3 read_warp(const json& value, const std::string& place) {
    require_known_keys(value, {"direction", "from", "to"}, place);
    const std::optional<Vec3> direction = point_at(value, "direction", place);
    const std::optional<Vec3> from = point_at(value, "from", place);
    const std::optional<Vec3> to = point_at(value, "to", place);
    if (direction.has_value() == (from || to) || from.has_value() != to.has_value())
        throw InputError(place +
                         ": expected either \"direction\" alone or both \"from\" and \"to\"; give one of the two");
    const Vec3 warp = direction ? *direction : *to - *from;
    const double length = warp.stableNorm();
    if (!(length > 0) || !std::isfinite(length))
        throw InputError(place + ": the warp has no direction, expected " +
                         (direction ? "a vector other than [0, 0, 0]" : "two different points") + "; correct it");
    return warp / length;
}

double compensation_of(const json& value, const std::string& place) {
    if (!value.is_number() || !(value.get<double>() > -50 && value.get<double>() < 100))
        throw InputError(place + ": expected a number of per cent above -50 and below 100");
    return value.get<double>() * percent;
}

Compensation read_compensation(const json& value, const std::string& place) {
    require_known_keys(value, {"warp_pct", "weft_pct", "chains_pct"}, place);
    Compensation compensation;
    if (value.contains("warp_pct")) compensation.warp = compensation_of(value["warp_pct"], place + ": warp_pct");
    if (value.contains("weft_pct")) compensation.weft = compensation_of(value["weft_pct"], place + ": weft_pct");
    if (value.contains("chains_pct")) {
        if (!value["chains_pct"].is_array())
            throw InputError(place + ": chains_pct is no list, expected per cents, one a chain: [0.2, 0, ...]");
        for (const json& chain : value["chains_pct"])
            compensation.chains.push_back(compensation_of(chain, place + ": chains_pct"));
    }
    return compensation;
}

ProjectTile read_tile(const json& value, const std::string& place) {
    require_known_keys(value, {"name", "warp", "corners", "compensation"}, place);
    ProjectTile tile;
    tile.name = text_at(value, "name", place).value_or("");
    if (tile.name.empty())
        throw InputError(place + ": no name, expected the tile's name or a pattern such as \"G01*\"; add \"name\"");
    const std::string named = place + " (" + shown(tile.name) + ")";
    if (value.contains("warp")) tile.warp = read_warp(value["warp"], named + ": warp");
    if (value.contains("corners")) {
        const json& corners = value["corners"];
        if (!corners.is_array() || corners.empty())
            throw InputError(named + ": corners is empty or no list, expected points: [[x, y, z], ...]");
        for (std::size_t i = 0; i < corners.size(); ++i)
            tile.corners.push_back(point_of(corners[i], named + ": corner " + std::to_string(i + 1)));
    }
    if (value.contains("compensation"))
        tile.compensation = read_compensation(value["compensation"], named + ": compensation");
    return tile;
}

void read_tolerances(const json& value, const std::string& place, Project& project) {
    require_known_keys(value, {"area_pct", "length_pct", "strain_pct", "shear_deg"}, place);
    const auto read = [&](const char* key, double unit, std::optional<double>& target) {
        const std::optional<double> given = number_at(value, key, place);
        if (given && !(*given > 0))
            throw InputError(place + ": " + key + " is " + format_shortest(*given) + ", expected a number above 0");
        if (given) target = *given * unit;
    };
    read("area_pct", percent, project.area);
    read("length_pct", percent, project.length);
    read("strain_pct", percent, project.strain);
    read("shear_deg", degree, project.shear);
}

void require_names_once(const Project& project) {
    std::map<std::string, std::size_t> first;
    for (std::size_t i = 0; i < project.tiles.size(); ++i)
        if (const auto [entry, is_new] = first.try_emplace(project.tiles[i].name, i + 1); !is_new)
            throw InputError(project.file + ": tiles " + std::to_string(entry->second) + " and " +
                             std::to_string(i + 1) + " have the same name " + shown(project.tiles[i].name) +
                             ", expected each name once; join them");
}

/// The entry that decides for a tile among those of which `gives` holds; nothing if there is none.
template <class Gives>
const ProjectTile* deciding(const Project& project, const std::string& tile_name, Gives&& gives) {
    const ProjectTile* found = nullptr;
    for (const ProjectTile& entry : project.tiles) {
        if (!gives(entry)) continue;
        if (entry.name == tile_name) return &entry;
        if (glob_match(entry.name, tile_name)) found = &entry;
    }
    return found;
}

}  // namespace

Project read_project(std::istream& in, const std::string& name) {
    const json object = read_json_object(in, name);
    require_known_keys(object, {"unit", "fabric", "tolerances", "seam_tolerance_mm", "tiles"}, name);
    Project project;
    project.file = name;
    project.unit = text_at(object, "unit", name);
    if (project.unit) try {
            metres_per_unit(*project.unit);
        } catch (const InputError& error) {
            throw InputError(name + ": " + error.what());
        }
    project.fabric = text_at(object, "fabric", name);
    if (object.contains("tolerances")) read_tolerances(object["tolerances"], name + ": tolerances", project);
    if (const std::optional<double> given = number_at(object, "seam_tolerance_mm", name)) {
        if (!(*given > 0))
            throw InputError(name + ": seam_tolerance_mm is " + format_shortest(*given) +
                             ", expected a number above 0");
        project.seam_tolerance = *given * millimetre;
    }
    if (object.contains("tiles")) {
        const json& tiles = object["tiles"];
        if (!tiles.is_array()) throw InputError(name + ": tiles is no list, expected [{\"name\": ...}, ...]");
        for (std::size_t i = 0; i < tiles.size(); ++i)
            project.tiles.push_back(read_tile(tiles[i], name + ": tile " + std::to_string(i + 1)));
    }
    require_names_once(project);
    return project;
}

TileOptions tile_options(const Project& project, const std::string& tile_name, double metres_per_unit) {
    TileOptions options;
    if (const ProjectTile* entry =
            deciding(project, tile_name, [](const ProjectTile& tile) { return tile.warp.has_value(); })) {
        options.warp = entry->warp;
        options.warp_source = std::filesystem::path(project.file).filename().string() + ", tile " + shown(entry->name);
    }
    if (const ProjectTile* entry =
            deciding(project, tile_name, [](const ProjectTile& tile) { return !tile.corners.empty(); }))
        for (const Vec3& corner : entry->corners) options.corners.push_back(corner * metres_per_unit);
    if (const ProjectTile* entry =
            deciding(project, tile_name, [](const ProjectTile& tile) { return tile.compensation.has_value(); }))
        options.compensation = *entry->compensation;
    return options;
}

Tolerances tolerances(const Project& project, const Tolerances& defaults) {
    return {project.area.value_or(defaults.area), project.length.value_or(defaults.length),
            project.strain.value_or(defaults.strain), project.shear.value_or(defaults.shear)};
}

std::vector<std::string> unused_names(const Project& project, const std::vector<std::string>& tile_names) {
    std::vector<std::string> unused;
    for (const ProjectTile& entry : project.tiles)
        if (std::none_of(tile_names.begin(), tile_names.end(), [&entry](const std::string& tile) {
                return entry.name == tile || glob_match(entry.name, tile);
            }))
            unused.push_back(entry.name);
    return unused;
}

}  // namespace ripstop
