#include "ripstop/report/words/proposals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "ripstop/base/index.h"
#include "ripstop/base/text/units.h"
#include "ripstop/model/plan/better_verdict.h"
#include "ripstop/report/figures/figures.h"

namespace ripstop {
namespace {

std::string place(const Vec3& at) {
    return "(" + shown(at.x() / millimetre, 0) + ", " + shown(at.y() / millimetre, 0) + ", " +
           shown(at.z() / millimetre, 0) + ") mm";
}

/// The strain with the largest absolute value.
double worst_strain(const Accuracy& a) {
    double worst = 0;
    for (const double strain : {a.warp_strain_min, a.warp_strain_max, a.weft_strain_min, a.weft_strain_max})
        if (std::abs(strain) > std::abs(worst)) worst = strain;
    return worst;
}

std::string findings(const Verdict& verdict) {
    return verdict.findings.empty() ? "none" : failing_codes(verdict);
}

std::string sentence(const FlatTile& tile, std::size_t count) {
    const SplitProposal& proposal = *tile.proposal;
    const Accuracy &left = proposal.halves[0].accuracy, &right = proposal.halves[1].accuracy;
    const auto both = [](double before, double one, double other, int decimals) {
        return shown(one / percent, decimals, true) + " and " + shown(other / percent, decimals, true) +
               " % instead of " + shown(before / percent, decimals, true) + " %";
    };
    return tile.tile.name + (count > 1 ? " and " + std::to_string(count - 1) + " alike" : "") + ": of " +
           std::to_string(proposal.tried) + " seams tried, the best runs " + proposal.direction + " from " +
           place(proposal.line.front()) + " to " + place(proposal.line.back()) + ";\n  the halves: area error " +
           both(tile.accuracy.area_error, left.area_error, right.area_error, 2) + ", largest strain " +
           both(worst_strain(tile.accuracy), worst_strain(left), worst_strain(right), 1) +
           ";\n  findings left: " + findings(proposal.halves[0].verdict) + " | " +
           findings(proposal.halves[1].verdict) + "\n";
}

std::string more(std::size_t count, const std::string& what) {
    return count > 0 ? "and " + std::to_string(count) + " more " + what + "; report.json has them all\n" : "";
}

}  // namespace

std::vector<ProposedKind> proposed_kinds(const CutPlan& plan) {
    std::vector<ProposedKind> kinds;
    std::map<int, std::size_t> known;
    for (std::size_t i = 0; i < plan.tiles.size(); ++i) {
        const FlatTile& tile = plan.tiles[i];
        if (!tile.proposal) continue;
        const auto [kind, is_new] =
            known.emplace(tile.equal_to >= 0 ? tile.equal_to : static_cast<int>(i), kinds.size());
        if (is_new)
            kinds.push_back({i});
        else
            ++kinds[kind->second].count;
    }
    return kinds;
}

std::string halves_words(const FlatTile& tile) {
    const std::array<Trial, 2>& halves = tile.proposal->halves;
    const auto is_good = [](const Trial& half) { return half.verdict.findings.empty(); };
    const auto better = [&](const Trial& half) { return is_better(half.verdict, tile.verdict); };
    const auto good = std::count_if(halves.begin(), halves.end(), is_good);
    const bool both_better = std::all_of(halves.begin(), halves.end(), better);
    if (good == 2) return "then both halves can be made";
    if (good == 1)
        return both_better ? "then one half can be made, and the other is better than the whole"
                           : "then one half can be made, but the other is no better than the whole";
    return both_better ? "both halves are better, but neither can be made yet" : "neither half can be made yet";
}

std::string proposals_text(const CutPlan& plan, int max_rows) {
    const std::size_t limit = static_cast<std::size_t>(std::max(0, max_rows));
    std::string splits, merges;
    const std::vector<ProposedKind> kinds = proposed_kinds(plan);
    for (std::size_t i = 0; i < std::min(limit, kinds.size()); ++i)
        splits += sentence(plan.tiles[kinds[i].tile], kinds[i].count);
    for (std::size_t i = 0; i < std::min(limit, plan.merges.size()); ++i) {
        const MergeProposal& merge = plan.merges[i];
        const auto name = [&](int tile) { return plan.tiles[at(tile)].tile.name; };
        merges += name(merge.tile_a) + " and " + name(merge.tile_b) + " could be one tile: area " +
                  shown(merge.merged.accuracy.area_error / percent, 3, true) + " %, largest strain " +
                  shown(worst_strain(merge.merged.accuracy) / percent, 2, true) + " %\n";
    }
    splits += more(kinds.size() - std::min(kinds.size(), limit), "proposals");
    merges += more(plan.merges.size() - std::min(plan.merges.size(), limit), "pairs");
    if (!splits.empty()) splits = "To draw instead (nothing was cut):\n" + splits;
    return splits + merges;
}

}  // namespace ripstop
