#include "ripstop/report/page/comparison.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "ripstop/base/text/number_text.h"
#include "ripstop/base/text/units.h"
#include "ripstop/report/figures/cloth_map.h"
#include "ripstop/report/figures/colour_scale.h"
#include "ripstop/report/figures/figures.h"
#include "ripstop/report/figures/text_table.h"
#include "ripstop/report/json/report_json.h"
#include "ripstop/report/view/drawing.h"

namespace ripstop {
namespace {

constexpr double cell_margin = 28;
constexpr double comparison_head = 64;  ///< head of the sheet
constexpr double tile_head = 40;        ///< above the shapes of a tile
constexpr double cell_width = 300;
constexpr double shape_height = 220;
constexpr double cell_head = 84;  ///< space above a shape for name, figures and verdict
constexpr int across = 4;         ///< shapes per row

std::string shown_percent(double ratio, int decimals, bool with_sign = true) {
    return shown(ratio / percent, decimals, with_sign);
}

/// Four significant digits: energies of tiles differ by orders of magnitude.
std::string significant(double value) {
    if (!std::isfinite(value) || value == 0) return shown(value, 0);
    const double scale = std::pow(10, 3 - std::floor(std::log10(std::abs(value))));
    return format_shortest(clean(std::round(value * scale) / scale));
}

TextRow row_of(const FlatTile& tile) {
    const Accuracy& a = tile.accuracy;
    const auto range = [](double low, double high) { return shown_percent(low, 2) + " " + shown_percent(high, 2); };
    return {shortened(tile.tile.name),
            tile.method,
            shown_percent(a.area_error, 4),
            shown_percent(a.area_error_abs, 4, false),
            shown_percent(a.perimeter_error, 4),
            shown_percent(a.boundary_error_max, 4, false),
            shown_percent(worst_chain_error(a), 4),
            shown_percent(a.edge_error_abs, 4, false),
            range(a.warp_strain_min, a.warp_strain_max),
            range(a.weft_strain_min, a.weft_strain_max),
            shown(a.shear_max / degree, 2),
            std::to_string(a.flipped),
            significant(a.energy),
            shown(tile.seconds, 3),
            tile.verdict.manufacturable() ? "ok" : "no: " + failing_codes(tile.verdict)};
}

/// The space that the shapes of a tile need on the cloth [m].
Vec2 largest_size(const std::vector<CutPlan>& plans, std::size_t tile) {
    Vec2 largest = Vec2::Constant(1e-9);
    for (const CutPlan& plan : plans)
        if (plan.tiles[tile].is_flat()) {
            const Points2& flat = plan.tiles[tile].flattening.positions;
            largest = largest.cwiseMax((flat.colwise().maxCoeff() - flat.colwise().minCoeff()).transpose());
        }
    return largest;
}

std::string shape(const FlatTile& tile, const Vec2& corner, double scale, const Tolerances& tolerances) {
    const Accuracy& a = tile.accuracy;
    const bool good = tile.verdict.manufacturable();
    std::string svg = svg_text(corner + Vec2(0, 18), tile.method, {16, "start", "#1f2933", true}) +
                      svg_text(corner + Vec2(0, 72), good ? "manufacturable" : "not manufacturable",
                               {12, "start", good ? "#18794e" : "#b3121f", true}) +
                      svg_text(corner + Vec2(0, 38),
                               "area " + shown_percent(a.area_error, 3) + " %  ·  edges up to " +
                                   shown_percent(a.boundary_error_max, 3, false) + " %",
                               {12, "start", "#1f2933"}) +
                      svg_text(corner + Vec2(0, 55),
                               "perimeter " + shown_percent(a.perimeter_error, 3) + " %  ·  flips " +
                                   std::to_string(a.flipped) + "  ·  " + shown(tile.seconds, 3) + " s",
                               {12, "start", "#52606d"});
    const Vec2 middle = corner + Vec2((cell_width - 24) / 2, cell_head + shape_height / 2);
    if (!tile.is_flat())
        return svg +
               svg_text(middle, "no flat positions: " + tile.flattening.summary.text(), {12, "middle", "#b3121f"});
    const Points2& flat = tile.flattening.positions;
    const Vec2 centre = 0.5 * (flat.colwise().maxCoeff() + flat.colwise().minCoeff()).transpose();
    const PageView view{scale, middle + scale * Vec2(-centre.x(), centre.y())};
    std::string outline;
    for (std::size_t c = 0; c < tile.tile.chains.size(); ++c) {
        std::vector<Vec2> points;
        for (const int v : tile.tile.chains[c].vertices) points.push_back(view.at(flat.row(v).transpose()));
        outline += svg_stroke(points, "#1f2933", 5) +
                   svg_stroke(points, class_colour(colour_class(a.chains[c].error(), tolerances.length)), 3.2);
    }
    return svg + cloth_map(tile, view, tolerances.strain) + outline;
}

}  // namespace

std::string comparison_table(const std::vector<CutPlan>& plans) {
    std::vector<TextRow> rows{{"tile", "method", "area %", "|dA| %", "perimeter %", "worst edge %", "worst chain %",
                               "all edges %", "warp %", "weft %", "shear deg", "flips", "energy J", "seconds",
                               "verdict"}};
    for (std::size_t t = 0; t < plans.front().tiles.size(); ++t)
        for (const CutPlan& plan : plans) rows.push_back(row_of(plan.tiles[t]));
    return aligned_table(rows, 2);
}

std::string comparison_json(const std::vector<CutPlan>& plans) {
    using Json = nlohmann::ordered_json;
    Json whole;
    for (const CutPlan& plan : plans) {
        Json report = Json::parse(report_json(plan));
        if (whole.is_null()) {
            for (const char* key : {"ripstop", "schema", "input", "fabric", "fabrics", "tolerances"})
                whole[key] = report[key];
            whole["tiles"] = Json::array();
            for (const FlatTile& tile : plan.tiles)
                whole["tiles"].push_back({{"name", tile.tile.name}, {"methods", Json::array()}});
        }
        for (std::size_t t = 0; t < plan.tiles.size(); ++t)
            whole["tiles"][t]["methods"].push_back(std::move(report["tiles"][t]));
    }
    return whole.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string comparison_sheet(const std::vector<CutPlan>& plans) {
    const std::size_t tiles = plans.front().tiles.size();
    const int columns = std::min(across, static_cast<int>(plans.size()));
    const int rows = (static_cast<int>(plans.size()) + columns - 1) / columns;
    const double width = std::max(640.0, 2 * cell_margin + columns * cell_width);
    const double tile_height = tile_head + rows * (cell_head + shape_height + 16);
    const double foot = comparison_head + static_cast<double>(tiles) * tile_height;
    const double height = foot + 84;
    const Tolerances& tolerances = plans.front().tolerances;
    const std::string size = svg_number(width) + "\" height=\"" + svg_number(height);
    std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + size + "\" viewBox=\"0 0 " +
                      svg_number(width) + " " + svg_number(height) +
                      "\" font-family=\"DejaVu Sans, Helvetica, Arial, sans-serif\">\n<rect width=\"" + size +
                      "\" fill=\"#ffffff\"/>\n" +
                      svg_text({cell_margin, 40}, "Every method on the same cloth: " + plans.front().fabric.name,
                               {22, "start", "#1f2933", true});
    for (std::size_t t = 0; t < tiles; ++t) {
        const double top = comparison_head + static_cast<double>(t) * tile_height;
        const Vec2 room = largest_size(plans, t);
        const double scale = std::min((cell_width - 40) / room.x(), shape_height / room.y());
        svg += svg_text({cell_margin, top + 24}, plans.front().tiles[t].tile.name, {18, "start", "#1f2933", true}) +
               scale_bar({width - cell_margin - 200, top + 22}, scale, 160);
        for (std::size_t m = 0; m < plans.size(); ++m) {
            const auto place = static_cast<int>(m);
            const Vec2 corner(cell_margin + place % columns * cell_width,
                              top + tile_head + place / columns * (cell_head + shape_height + 16));
            svg += shape(plans[m].tiles[t], corner, scale, tolerances);
        }
    }
    return svg +
           colour_bar({cell_margin + 6, foot + 30}, "cloth: |edge length error|, mean of a triangle",
                      tolerances.strain / percent, "%") +
           colour_bar({cell_margin + 346, foot + 30}, "seams: |length error| of a chain", tolerances.length / percent,
                      "%") +
           "</svg>\n";
}

}  // namespace ripstop
