#include "ripstop/report/tables/tables.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <vector>

#include "ripstop/base/index.h"
#include "ripstop/base/text/number_text.h"
#include "ripstop/base/text/units.h"
#include "ripstop/report/figures/figures.h"
#include "ripstop/report/figures/text_table.h"
#include "ripstop/report/tables/csv.h"
#include "ripstop/report/tables/seam_tables.h"

namespace ripstop {
namespace {

using Row = TextRow;

constexpr std::array tile_columns{"name",
                                  "vertices",
                                  "triangles",
                                  "method",
                                  "manufacturable",
                                  "area_m2",
                                  "flat_area_m2",
                                  "area_error_pct",
                                  "area_error_abs_pct",
                                  "perimeter_mm",
                                  "perimeter_error_pct",
                                  "edge_error_abs_pct",
                                  "boundary_error_abs_pct",
                                  "boundary_error_max_pct",
                                  "chain_error_max_pct",
                                  "warp_min_pct",
                                  "warp_max_pct",
                                  "weft_min_pct",
                                  "weft_max_pct",
                                  "shear_max_deg",
                                  "energy_j",
                                  "flipped",
                                  "overlaps",
                                  "stop",
                                  "finding",
                                  "equal_to",
                                  "mirror_of",
                                  "quantity",
                                  "quantity_mirrored",
                                  "fabric"};

Row csv_row(const FlatTile& tile, const std::string& equal_to, const Quantity& cut, const std::string& fabric) {
    const Accuracy& a = tile.accuracy;
    const std::vector<Finding>& findings = tile.verdict.findings;
    return {tile.tile.name,
            std::to_string(tile.tile.mesh.vertex_count()),
            std::to_string(tile.tile.mesh.triangle_count()),
            tile.method,
            tile.verdict.manufacturable() ? "true" : "false",
            csv_figure(a.area),
            csv_figure(a.flat_area),
            csv_figure(a.area_error / percent),
            csv_figure(a.area_error_abs / percent),
            csv_figure(a.perimeter / millimetre),
            csv_figure(a.perimeter_error / percent),
            csv_figure(a.edge_error_abs / percent),
            csv_figure(a.boundary_error_abs / percent),
            csv_figure(a.boundary_error_max / percent),
            csv_figure(worst_chain_error(a) / percent),
            csv_figure(a.warp_strain_min / percent),
            csv_figure(a.warp_strain_max / percent),
            csv_figure(a.weft_strain_min / percent),
            csv_figure(a.weft_strain_max / percent),
            csv_figure(a.shear_max / degree),
            csv_figure(a.energy),
            std::to_string(a.flipped),
            std::to_string(a.overlaps),
            name(tile.flattening.summary.termination),
            findings.empty() ? "" : findings.front().message,
            tile.mirrored ? "" : equal_to,
            tile.mirrored ? equal_to : "",
            std::to_string(cut.same),
            std::to_string(cut.mirrored),
            fabric};
}

const Row headings{"tile",   "triangles", "area %",    "perimeter %", "worst chain %",
                   "warp %", "weft %",    "shear deg", "flips",       "verdict"};

std::string range(double low, double high) {
    return shown(low / percent, 2, true) + " " + shown(high / percent, 2, true);
}

Row table_row(const FlatTile& tile) {
    const Accuracy& a = tile.accuracy;
    return {shortened(tile.tile.name),
            std::to_string(tile.tile.mesh.triangle_count()),
            shown(a.area_error / percent, 3, true),
            shown(a.perimeter_error / percent, 3, true),
            shown(worst_chain_error(a) / percent, 3, true),
            range(a.warp_strain_min, a.warp_strain_max),
            range(a.weft_strain_min, a.weft_strain_max),
            shown(a.shear_max / degree, 2),
            std::to_string(a.flipped),
            tile.verdict.manufacturable() ? "ok" : "no: " + failing_codes(tile.verdict)};
}

/// `360 tiles, 15 different, each cut 24 times`; empty if no two are alike.
std::string kinds(const CutPlan& plan) {
    std::map<int, int, std::greater<>> times;  // the number of patterns that are cut so often
    bool turned = false;
    for (const Quantity& cut : quantities(plan)) {
        if (cut.same + cut.mirrored > 0) ++times[cut.same + cut.mirrored];
        turned = turned || cut.mirrored > 0;
    }
    int different = 0;
    for (const auto& [often, patterns] : times) different += patterns;
    if (static_cast<std::size_t>(different) == plan.tiles.size()) return {};
    std::string text = std::to_string(plan.tiles.size()) + " tiles, " + std::to_string(different) + " different";
    for (const auto& [often, patterns] : times) {
        if (often == 1) continue;
        text += times.size() == 1 ? ", " + std::string(different == 1 ? "" : "each ")
                                  : ", " + std::to_string(patterns) + " of them ";
        text += std::to_string(often) + " times";
    }
    return text + (turned ? ", mirror images counted together\n" : "\n");
}

struct Worst {
    double value = 0;
    std::string tile;
    void consider(double candidate, const FlatTile& from) {
        if (std::isnan(value) || std::abs(candidate) <= std::abs(value)) return;
        value = candidate;
        tile = shortened(from.tile.name);
    }
    std::string text(const char* what, double unit, int decimals, const char* unit_text, bool with_sign) const {
        return std::string(what) + " " + shown(value / unit, decimals, with_sign) + unit_text +
               (tile.empty() ? "" : " (" + tile + ")");
    }
};

/// `12 of 360 tiles remeshed: 2400 triangles to 24000; against the drawn mesh: area +0.040 % (G01), up to 1.2 mm
/// off`; empty if no tile was remeshed.
std::string remeshed_summary(const CutPlan& plan) {
    long long count = 0, before = 0, now = 0;
    Worst change;
    double distance = 0;
    for (const FlatTile& tile : plan.tiles) {
        if (!tile.tile.remeshed) continue;
        ++count;
        change.consider(tile.accuracy.area / tile.tile.remeshed->area_before - 1, tile);
        distance = std::max(distance, tile.tile.remeshed->distance_max);
        before += tile.tile.remeshed->triangles_before;
        now += tile.tile.mesh.triangle_count();
    }
    if (count == 0) return {};
    return std::to_string(count) + " of " + std::to_string(plan.tiles.size()) +
           (plan.tiles.size() == 1 ? " tile" : " tiles") + " remeshed: " + std::to_string(before) + " triangles to " +
           std::to_string(now) + "; against the drawn mesh: " + change.text("area", percent, 3, " %", true) +
           ", up to " + shown(distance / millimetre, 1, false) + " mm off\n";
}

}  // namespace

std::string tiles_csv(const CutPlan& plan) {
    std::string text;
    add_csv_line(text, Row(tile_columns.begin(), tile_columns.end()));
    const std::vector<Quantity> cut = quantities(plan);
    for (std::size_t i = 0; i < plan.tiles.size(); ++i) {
        const FlatTile& tile = plan.tiles[i];
        add_csv_line(text, csv_row(tile, tile.equal_to < 0 ? std::string() : plan.tiles[at(tile.equal_to)].tile.name,
                                   cut[i], plan.fabric_of(tile.tile).name));
    }
    return text;
}

std::string plan_summary(const CutPlan& plan) {
    Worst area, perimeter, chain, strain, shear;
    int good = 0, flipped = 0;
    for (const FlatTile& tile : plan.tiles) {
        const Accuracy& a = tile.accuracy;
        good += tile.verdict.manufacturable();
        flipped += a.flipped;
        area.consider(a.area_error, tile);
        perimeter.consider(a.perimeter_error, tile);
        chain.consider(worst_chain_error(a), tile);
        for (const double value : {a.warp_strain_min, a.warp_strain_max, a.weft_strain_min, a.weft_strain_max})
            strain.consider(value, tile);
        shear.consider(a.shear_max, tile);
    }
    return std::to_string(good) + " of " + std::to_string(plan.tiles.size()) +
           (plan.tiles.size() == 1 ? " tile" : " tiles") + " manufacturable, " + shown(plan.area(), 2) +
           " m2 of cloth\n" + "worst: " + area.text("area", percent, 3, " %", true) + ", " +
           perimeter.text("perimeter", percent, 3, " %", true) + ", " + chain.text("chain", percent, 3, " %", true) +
           ",\n       " + strain.text("strain", percent, 2, " %", true) + ", " +
           shear.text("shear", degree, 2, " deg", false) + ", " + std::to_string(flipped) + " flipped\n" + kinds(plan) +
           remeshed_summary(plan) + seams_summary(plan);
}

std::string tiles_table(const CutPlan& plan, int max_rows) {
    const std::size_t limit = static_cast<std::size_t>(std::max(0, max_rows));
    const bool all = plan.tiles.size() <= limit;
    std::vector<Row> rows{headings};
    for (const FlatTile& tile : plan.tiles)
        if (all || (!tile.verdict.manufacturable() && rows.size() <= limit)) rows.push_back(table_row(tile));
    const std::size_t hidden = plan.tiles.size() - (rows.size() - 1);
    std::string text = rows.size() > 1 ? aligned_table(rows, 1) : "";
    if (hidden > 0) {
        const auto failing = std::count_if(plan.tiles.begin(), plan.tiles.end(),
                                           [](const FlatTile& tile) { return !tile.verdict.manufacturable(); });
        const std::size_t hidden_failing = static_cast<std::size_t>(failing) - (rows.size() - 1);
        text += std::to_string(hidden) + (rows.size() > 1 ? " more tiles, " : " tiles, ") +
                std::to_string(hidden_failing) + " of them failing; tiles.csv has them all\n";
    }
    return text + plan_summary(plan);
}

}  // namespace ripstop
