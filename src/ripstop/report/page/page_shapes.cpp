#include "ripstop/report/page/page_shapes.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "ripstop/base/text/units.h"
#include "ripstop/report/figures/cloth_map.h"
#include "ripstop/report/figures/figures.h"
#include "ripstop/report/page/packed_arrays.h"

namespace ripstop {
namespace {

using Json = nlohmann::ordered_json;

constexpr double drawing_step = 0.01 * millimetre;
constexpr double finest_strain = 1e-5;
constexpr double finest_edge_error = 1e-6;
constexpr double finest_tension = 1e-4;    // [N]
constexpr double finest_deviation = 1e-5;  // [m]
constexpr double finest_stress = 1e-3;     // [N/m]

Json grid_json(const Eigen::MatrixXd& points, PackedArrays& arrays) {
    const GridPoints grid = on_grid(points);
    Json lower = Json::array();
    for (const double value : grid.lower) lower.push_back(clean(value));
    return {{"array", arrays.add_steps(grid.values, static_cast<std::size_t>(points.cols()))},
            {"lower_m", lower},
            {"step_m", grid.step}};
}

Json map_json(const Eigen::VectorXd& values, double finest, PackedArrays& arrays) {
    const SteppedValues map = stepped(values, finest);
    return {{"array", arrays.add(map.values)}, {"step", map.step}};
}

/// Numbers of vertices, in 16 bits where the tile has no more.
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

void add_maps(Json& json, const FlatTile& tile, const StrainMap& strain, PackedArrays& arrays) {
    Eigen::VectorXd edges(tile.tile.mesh.triangle_count());
    for (int t = 0; t < tile.tile.mesh.triangle_count(); ++t) edges[t] = mean_edge_error(tile, t);
    json["maps"]["edges"] = map_json(edges, finest_strain, arrays);
    if (strain.warp.size() == edges.size()) {
        json["maps"]["warp"] = map_json(strain.warp, finest_strain, arrays);
        json["maps"]["weft"] = map_json(strain.weft, finest_strain, arrays);
        json["maps"]["shear"] = map_json(strain.shear, finest_strain, arrays);
        json["maps"]["area"] = map_json(strain.area, finest_strain, arrays);
    }
    const Eigen::VectorXd flat = edge_lengths(tile.flattening.positions, closed(tile.tile.boundary));
    json["edge_error"] =
        map_json((flat.array() / target_lengths(tile.tile).array() - 1).matrix(), finest_edge_error, arrays);
    const Eigen::VectorXd& tension = tile.flattening.seam_tension;
    if (tension.size() == flat.size()) json["tension"] = map_json(tension, finest_tension, arrays);
}

Json flight_json(const InflatedTile& tile, PackedArrays& arrays) {
    std::vector<std::int16_t> states;
    for (const ClothState state : tile.state) states.push_back(static_cast<std::int16_t>(state));
    return {{"space", grid_json(tile.positions, arrays)},
            {"deviation", map_json(tile.deviation, finest_deviation, arrays)},
            {"tension", map_json(tile.tension.col(0), finest_stress, arrays)},
            {"warp", map_json(tile.stress.col(0), finest_stress, arrays)},
            {"weft", map_json(tile.stress.col(1), finest_stress, arrays)},
            {"shear", map_json(tile.stress.col(2), finest_stress, arrays)},
            {"strain_warp", map_json(tile.strain.col(0), finest_strain, arrays)},
            {"strain_weft", map_json(tile.strain.col(1), finest_strain, arrays)},
            {"strain_shear", map_json(tile.strain.col(2), finest_strain, arrays)},
            {"state", {{"array", arrays.add(states)}, {"step", 1}}}};
}

Json tile_json(const FlatTile& tile, const Tolerances& limits, const StrainMap& strain, PackedArrays& arrays) {
    const TriangleMesh& mesh = tile.tile.mesh;
    std::vector<int> corners;
    for (int t = 0; t < mesh.triangle_count(); ++t)
        for (int k = 0; k < 3; ++k) corners.push_back(mesh.triangles(t, k));
    Json json = {{"space", grid_json(mesh.positions, arrays)},
                 {"triangles", add_vertices(corners, mesh.vertex_count(), 3, arrays)},
                 {"loop", add_vertices(tile.tile.boundary, mesh.vertex_count(), 1, arrays)},
                 {"chains", chain_starts(tile.tile)},
                 {"strain_limit", clean(limits.strain)},
                 {"shear_limit", clean(limits.shear)}};
    if (!is_drawable(tile)) return json;
    json["flat"] = grid_json(tile.flattening.positions, arrays);
    add_maps(json, tile, strain, arrays);
    return json;
}

/// A seam may begin and end within an edge. One that lies within a single edge is taken to lie about its middle.
Json side_json(const SeamSide& side, const Eigen::VectorXd& drawn) {
    const auto share = [&](const SeamPart& part) { return std::min(1.0, part.length / drawn[part.edge]); };
    const double first = share(side.parts.front()), last = share(side.parts.back());
    const bool is_one = side.parts.size() == 1;
    return {{"tile", side.tile},
            {"first", side.parts.front().edge},
            {"count", side.parts.size()},
            {"from", clean(is_one ? (1 - first) / 2 : 1 - first)},
            {"to", clean(is_one ? (1 + last) / 2 : last)}};
}

Json seams_json(const CutPlan& plan) {
    std::vector<Eigen::VectorXd> drawn;
    for (const FlatTile& tile : plan.tiles) drawn.push_back(drawn_lengths(tile.tile));
    Json seams = Json::array();
    for (const Seam& seam : plan.seams) {
        if (seams.size() == plan.walks.size()) break;  // report.json has those that were walked
        Json json = Json::object();
        for (const auto& [key, side] : {std::pair{"a", &seam.a}, std::pair{"b", &seam.b}})
            if (!side->parts.empty()) json[key] = side_json(*side, drawn[static_cast<std::size_t>(side->tile)]);
        seams.push_back(json);
    }
    return seams;
}

int add_line(const Points2& points, PackedArrays& arrays) {
    std::vector<std::uint32_t> values;
    for (Eigen::Index i = 0; i < points.rows(); ++i)
        for (Eigen::Index k = 0; k < 2; ++k)
            values.push_back(static_cast<std::uint32_t>(std::llround(points(i, k) / drawing_step)));
    return arrays.add_steps(values, 2);
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
    std::size_t tile = 0;  // pieces stand in the order of their tiles
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
    Json tiles = Json::array();
    for (std::size_t i = 0; i < plan.tiles.size(); ++i) {
        tiles.push_back(tile_json(plan.tiles[i], plan.tolerances_of(plan.tiles[i].tile),
                                  i < strains.size() ? strains[i] : StrainMap(), arrays));
        if (plan.inflated) tiles.back()["flight"] = flight_json(plan.inflated->tiles[i], arrays);
    }
    Json json = {{"tiles", tiles}, {"seams", seams_json(plan)}, {"pieces", pieces_json(plan, pieces, arrays)}};
    json["arrays"] = Json::array();
    for (const PackedArrays::Place& place : arrays.places()) json["arrays"].push_back({place.start, place.length});
    std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
    text.resize((text.size() + 3) / 4 * 4, ' ');
    std::string bytes = "RSP1";
    for (std::size_t k = 0; k < 4; ++k) bytes += static_cast<char>((text.size() >> (8 * k)) & 0xff);
    return bytes + text + arrays.bytes();
}

}  // namespace ripstop
