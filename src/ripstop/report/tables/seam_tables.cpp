#include "ripstop/report/tables/seam_tables.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "ripstop/base/index.h"
#include "ripstop/base/text/units.h"
#include "ripstop/report/figures/figures.h"
#include "ripstop/report/tables/csv.h"

namespace ripstop {
namespace {

constexpr std::array seam_columns{
    "id",        "tile_a",      "chain_a",      "tile_b",       "chain_b",         "length_mm",      "flat_a_mm",
    "flat_b_mm", "mismatch_mm", "mismatch_pct", "drift_max_mm", "drift_max_at_mm", "limit_mm",       "uncertainty_mm",
    "gap_mm",    "certain",     "ok",           "type",         "allowance_a_mm",  "allowance_b_mm", "sewn_into"};

const std::string& tile_name(const CutPlan& plan, const SeamSide& side) {
    return plan.tiles[at(side.tile)].tile.name;
}

/// The seam with the largest absolute `value`; NaN counts as largest.
template <class Value>
std::size_t worst_seam(const CutPlan& plan, Value value) {
    std::size_t worst = 0;
    for (std::size_t i = 0; i < plan.walks.size(); ++i) {
        if (std::isnan(value(plan.walks[i]))) return i;
        if (std::abs(value(plan.walks[i])) > std::abs(value(plan.walks[worst]))) worst = i;
    }
    return worst;
}

std::string in_mm(double length) {
    return shown(length / millimetre, 3, true) + " mm";
}

/// How many seams agree, and the worst of them; empty without seams.
std::string agreement(const CutPlan& plan) {
    if (plan.walks.empty()) return {};
    const auto good = std::count_if(plan.walks.begin(), plan.walks.end(), [](const SeamWalk& walk) { return walk.ok; });
    const std::size_t mismatch = worst_seam(plan, [](const SeamWalk& walk) { return walk.mismatch(); });
    const std::size_t drift = worst_seam(plan, [](const SeamWalk& walk) { return walk.drift_max; });
    const SeamWalk& worst = plan.walks[mismatch];
    return std::to_string(good) + " of " + std::to_string(plan.walks.size()) +
           (plan.walks.size() == 1 ? " seam agrees" : " seams agree") + "; worst: mismatch " + in_mm(worst.mismatch()) +
           ", " + shown(worst.mismatch_ratio() / percent, 4, true) + " % (" + plan.seams[mismatch].id + "), drift " +
           shown(plan.walks[drift].drift_max / millimetre, 3) + " mm (" + plan.seams[drift].id + ")\n";
}

/// For how many seams the uncertainty of the meshes exceeds the tolerance.
std::string uncertain(const CutPlan& plan) {
    const auto count =
        std::count_if(plan.walks.begin(), plan.walks.end(), [](const SeamWalk& walk) { return !walk.is_certain(); });
    if (count == 0) return {};
    const std::size_t worst = worst_seam(plan, [](const SeamWalk& walk) { return walk.uncertainty; });
    return std::to_string(count) + (count == 1 ? " of them is" : " of them are") +
           " not certain: the meshes leave up to " + shown(plan.walks[worst].uncertainty / millimetre, 2) + " mm of " +
           plan.seams[worst].id + " uncertain, more than the tolerance; mesh its edges more finely\n";
}

}  // namespace

std::string seams_csv(const CutPlan& plan) {
    std::string text;
    add_csv_line(text, {seam_columns.begin(), seam_columns.end()});
    for (std::size_t i = 0; i < plan.walks.size(); ++i) {
        const Seam& seam = plan.seams[i];
        const SeamWalk& walk = plan.walks[i];
        const auto mm = [](double length) { return csv_figure(length / millimetre); };
        add_csv_line(text, {seam.id,
                            tile_name(plan, seam.a),
                            std::to_string(seam.a.chain + 1),
                            tile_name(plan, seam.b),
                            std::to_string(seam.b.chain + 1),
                            mm(walk.length),
                            mm(walk.flat_a),
                            mm(walk.flat_b),
                            mm(walk.mismatch()),
                            csv_figure(walk.mismatch_ratio() / percent),
                            mm(walk.drift_max),
                            mm(walk.drift_max_at),
                            mm(walk.limit),
                            mm(walk.uncertainty),
                            mm(seam.gap),
                            walk.is_certain() ? "true" : "false",
                            walk.ok ? "true" : "false",
                            seam.type.name,
                            mm(seam.allowance(seam.a)),
                            mm(seam.allowance(seam.b)),
                            seam.into ? plan.seams[at(seam.into->seam)].id : ""});
    }
    return text;
}

std::string seams_summary(const CutPlan& plan, int max_rows) {
    std::string text = agreement(plan) + uncertain(plan);
    const std::size_t limit = static_cast<std::size_t>(std::max(0, max_rows));
    for (std::size_t i = 0; i < std::min(limit, plan.findings.size()); ++i)
        text += "  " + plan.findings[i].message + "\n";
    if (plan.findings.size() > limit)
        text += "  and " + std::to_string(plan.findings.size() - limit) + " more; report.json has them all\n";
    return text;
}

std::vector<std::vector<std::vector<int>>> seams_of_chains(const CutPlan& plan) {
    std::vector<std::vector<std::vector<int>>> seams;
    std::vector<std::vector<int>> place;  // the index of each boundary edge in its chain
    for (const FlatTile& tile : plan.tiles) {
        seams.emplace_back(tile.tile.chains.size());
        std::vector<int> leaving(static_cast<std::size_t>(tile.tile.mesh.vertex_count()), 0);
        for (const Chain& chain : tile.tile.chains)
            for (int i = 0; i < chain.edge_count(); ++i)
                leaving[static_cast<std::size_t>(chain.vertices[static_cast<std::size_t>(i)])] = i;
        place.emplace_back();
        for (const int v : tile.tile.boundary) place.back().push_back(leaving[static_cast<std::size_t>(v)]);
    }
    std::vector<std::vector<std::vector<int>>> begins = seams;
    for (std::size_t s = 0; s < plan.seams.size(); ++s)
        for (const SeamSide* side : {&plan.seams[s].a, &plan.seams[s].b}) {
            if (side->parts.empty()) continue;
            const auto t = static_cast<std::size_t>(side->tile), c = static_cast<std::size_t>(side->chain);
            // A seam that begins within an edge comes after the seam that ends in it: that edge is its first, not
            // its last.
            const int begin =
                2 * place[t][static_cast<std::size_t>(side->parts.front().edge)] + (side->parts.size() > 1 ? 1 : 0);
            const auto at = std::upper_bound(begins[t][c].begin(), begins[t][c].end(), begin) - begins[t][c].begin();
            begins[t][c].insert(begins[t][c].begin() + at, begin);
            seams[t][c].insert(seams[t][c].begin() + at, static_cast<int>(s));
        }
    return seams;
}

}  // namespace ripstop
