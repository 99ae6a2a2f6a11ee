#include "ripstop/report/page/page_shapes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>

#include "ripstop/base/text/units.h"
#include "ripstop/report/figures/figures.h"
#include "ripstop/report/figures/seam_drift.h"
#include "ripstop/report/page/packed_arrays.h"
#include "ripstop/report/view/envelope_view.h"
#include "ripstop/report/view/first_tile.h"
#include "ripstop/report/view/map_view.h"
#include "ripstop/report/view/page_colours.h"
#include "ripstop/report/view/piece_marks.h"
#include "ripstop/tile/targets.h"

namespace ripstop {
namespace {

using Json = nlohmann::ordered_json;

constexpr double drawing_step = 0.01 * millimetre;

Json grid_json(const Eigen::MatrixXd& points, PackedArrays& arrays) {
    const GridPoints grid = on_grid(points);
    Json lower = Json::array();
    for (const double value : grid.lower) lower.push_back(clean(value));
    return {{"array", arrays.add_steps(grid.values, static_cast<std::size_t>(points.cols()))},
            {"lower_m", lower},
            {"step_m", grid.step}};
}

Json values_json(const Eigen::VectorXd& values, double finest, PackedArrays& arrays) {
    const SteppedValues map = stepped(values, finest);
    return {{"array", arrays.add(map.values)}, {"step", map.step}};
}

/// Vertex numbers, in 16 bits if the tile has few enough vertices.
int add_vertices(const std::vector<int>& vertices, int vertex_count, std::size_t columns, PackedArrays& arrays) {
    if (vertex_count < 65536)
        return arrays.add_steps(std::vector<std::uint16_t>(vertices.begin(), vertices.end()), columns);
    return arrays.add_steps(std::vector<std::uint32_t>(vertices.begin(), vertices.end()), columns);
}

Json chain_starts(const Tile& tile) {
    std::vector<int> place(static_cast<std::size_t>(tile.mesh.vertex_count()), 0);
    for (std::size_t i = 0; i < tile.boundary.size(); ++i)
        place[static_cast<std::size_t>(tile.boundary[i])] = static_cast<int>(i);
    Json starts = Json::array();
    for (const Chain& chain : tile.chains) starts.push_back(place[static_cast<std::size_t>(chain.vertices.front())]);
    return starts;
}

int add_line(const Points2& points, PackedArrays& arrays) {
    std::vector<std::uint32_t> values;
    for (Eigen::Index i = 0; i < points.rows(); ++i)
        for (Eigen::Index k = 0; k < 2; ++k)
            values.push_back(static_cast<std::uint32_t>(std::llround(points(i, k) / drawing_step)));
    return arrays.add_steps(values, 2);
}

Json tile_json(const FlatTile& tile, const Tolerances& limits, PackedArrays& arrays) {
    const TriangleMesh& mesh = tile.tile.mesh;
    std::vector<int> corners;
    for (int t = 0; t < mesh.triangle_count(); ++t)
        for (int k = 0; k < 3; ++k) corners.push_back(mesh.triangles(t, k));
    Json json = {{"space", grid_json(mesh.positions, arrays)},
                 {"triangles", add_vertices(corners, mesh.vertex_count(), 3, arrays)},
                 {"loop", add_vertices(tile.tile.boundary, mesh.vertex_count(), 1, arrays)},
                 {"chains", chain_starts(tile.tile)},
                 {"strain_limit", clean(limits.strain)},
                 {"shear_limit", clean(limits.shear)},
                 {"maps", Json::object()},
                 {"edges", Json::object()}};
    if (!tile.is_flat()) return json;
    json["flat"] = grid_json(tile.flattening.positions, arrays);
    json["rings"] = Json::array();
    for (const FindingMark& mark : finding_marks(tile)) json["rings"].push_back({mark.vertex, mark.finding});
    Points2 ends(0, 2);
    for (const Vec2& end : proposed_ends(tile)) {
        ends.conservativeResize(ends.rows() + 1, 2);
        ends.row(ends.rows() - 1) = end.transpose();
    }
    if (ends.rows() > 0) json["proposed"] = add_line(ends, arrays);
    return json;
}

Json scale_json(const MapScale& scale) {
    Json json = {{"id", scale.id}};
    if (!scale.cloth.empty()) {
        json["cloth"] = scale.cloth;
        const bool is_one =
            std::adjacent_find(scale.cloth.begin(), scale.cloth.end(), std::not_equal_to<>()) == scale.cloth.end();
        if (is_one) json["cloth"] = scale.cloth.front();
    }
    json.update({{"edges", scale.edges},
                 {"beyond", scale.has_beyond},
                 {"low", scale.low},
                 {"middle", scale.middle},
                 {"high", scale.high},
                 {"note", scale.note}});
    return json;
}

Json map_json(const MapView& view) {
    const PageMap& map = *view.map;
    Json json = {{"id", map.id},
                 {"name", map.name},
                 {"negative", map.negative},
                 {"positive", map.positive},
                 {"unsigned", map.is_unsigned},
                 {"in_flight", map.is_in_flight},
                 {"of_edges", map.is_of_edges()},
                 {"states", Json::array()},
                 {"scales", Json::array()}};
    if (map.is_of_states()) json["states"] = cloth_states;
    for (const MapScale& scale : view.scales) json["scales"].push_back(scale_json(scale));
    return json;
}

/// The step is below what is visible in the finest scale.
double finest_step(double end) {
    constexpr double steps = 1000;
    return end / steps;
}

/// Adds the values of a map to each tile's `maps` and `edges`.
void add_values(Json& tiles, const MapView& view, PackedArrays& arrays) {
    const auto there =
        std::find_if(view.scales.begin(), view.scales.end(), [](const MapScale& scale) { return scale.id == "there"; });
    const std::string id(view.map->id);
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        if (view.cloth[i].size() > 0)
            tiles[i]["maps"][id] =
                values_json(view.cloth[i], there->cloth.empty() ? 1 : finest_step(there->cloth[i]), arrays);
        if (!view.edges.empty()) tiles[i]["edges"][id] = values_json(view.edges[i], finest_step(there->edges), arrays);
    }
}

Json palettes_json() {
    Json palettes = Json::array();
    for (const PagePalette& palette : page_palettes())
        palettes.push_back({{"id", palette.id}, {"name", palette.name}, {"colours", colours_text(palette.colours)}});
    return palettes;
}

Json side_json(const SeamSide& side, const Eigen::VectorXd& drawn) {
    const std::size_t last = side.parts.size() - 1;
    return {{"tile", side.tile},
            {"first", side.parts.front().edge},
            {"count", side.parts.size()},
            {"from", clean(share_of_edge(side, 0, drawn[side.parts.front().edge])[0])},
            {"to", clean(share_of_edge(side, last, drawn[side.parts.back().edge])[1])}};
}

Json seams_json(const CutPlan& plan) {
    std::vector<Eigen::VectorXd> drawn;
    for (const FlatTile& tile : plan.tiles) drawn.push_back(drawn_lengths(tile.tile));
    Json seams = Json::array();
    for (const Seam& seam : plan.seams) {
        if (seams.size() == plan.walks.size()) break;  // report.json has only the seams that were walked
        Json json = Json::object();
        for (const auto& [key, side] : {std::pair{"a", &seam.a}, std::pair{"b", &seam.b}})
            if (!side->parts.empty()) json[key] = side_json(*side, drawn[static_cast<std::size_t>(side->tile)]);
        seams.push_back(json);
    }
    return seams;
}

Json in_millimetres(const Vec2& at) {
    const auto rounded = [](double length) { return clean(std::round(length / drawing_step) / 100); };
    return {rounded(at.x()), rounded(at.y())};
}

Json piece_json(const PatternPiece& piece, std::size_t tile, PackedArrays& arrays) {
    Json lines = Json::array(), labels = Json::array();
    for (const DrawnLine& line : piece.lines)
        lines.push_back({{"name", line.name}, {"points", add_line(line.points, arrays)}});
    for (const Label& label : piece.labels)
        labels.push_back({{"text", label.text},
                          {"at_mm", in_millimetres(label.middle)},
                          {"height_mm", clean(label.height / millimetre)},
                          {"turn_deg", clean(label.turn / degree)}});
    std::vector<Vec2> ends;
    for (const PieceNotch& notch : piece.notches)
        for (const auto& [from, to] : notch.slits()) ends.insert(ends.end(), {from, to});
    Points2 slits(static_cast<Eigen::Index>(ends.size()), 2);
    for (std::size_t i = 0; i < ends.size(); ++i) slits.row(static_cast<Eigen::Index>(i)) = ends[i].transpose();
    return {{"tile", tile},
            {"cut", add_line(piece.outline(), arrays)},
            {"sew", add_line(piece.sew_line, arrays)},
            {"slits", add_line(slits, arrays)},
            {"grain", add_line(piece.grain_line, arrays)},
            {"lines", lines},
            {"labels", labels}};
}

Json pieces_json(const CutPlan& plan, const std::vector<PatternPiece>& pieces, PackedArrays& arrays) {
    Json list = Json::array();
    std::size_t tile = 0;  // pieces are in the order of their tiles
    for (const PatternPiece& piece : pieces) {
        while (tile < plan.tiles.size() && plan.tiles[tile].tile.name != piece.name) ++tile;
        if (tile == plan.tiles.size()) break;
        list.push_back(piece_json(piece, tile++, arrays));
    }
    return list;
}

}  // namespace

std::string page_shapes(const CutPlan& plan, const std::vector<PatternPiece>& pieces,
                        const std::vector<StrainMap>& strains) {
    PackedArrays arrays;
    Json tiles = Json::array(), maps = Json::array();
    for (std::size_t i = 0; i < plan.tiles.size(); ++i) {
        tiles.push_back(tile_json(plan.tiles[i], plan.tolerances_of(plan.tiles[i].tile), arrays));
        if (plan.inflated) tiles.back()["flight"] = {{"space", grid_json(plan.inflated->tiles[i].positions, arrays)}};
    }
    const std::string_view first = first_map(plan, strains);
    int chosen = -1;
    for (const std::string_view id : maps_of(plan, strains)) {
        const MapView view = map_view(plan, strains, page_map(id));
        maps.push_back(map_json(view));
        add_values(tiles, view, arrays);
        if (id == first) chosen = first_tile(plan, view);
    }
    Json json = {{"palettes", palettes_json()},
                 {"maps", maps},
                 {"first", {{"map", first}, {"tile", chosen}}},
                 {"is_y_up", envelope_shape(plan).is_y_up},
                 {"tiles", tiles},
                 {"seams", seams_json(plan)},
                 {"pieces", pieces_json(plan, pieces, arrays)}};
    json["arrays"] = Json::array();
    for (const PackedArrays::Section& place : arrays.places()) json["arrays"].push_back({place.start, place.length});
    std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
    text.resize((text.size() + 3) / 4 * 4, ' ');
    std::string bytes = "RSP1";
    for (std::size_t k = 0; k < 4; ++k) bytes += static_cast<char>((text.size() >> (8 * k)) & 0xff);
    return bytes + text + arrays.bytes();
}

}  // namespace ripstop
