#include "ripstop/report/proposals.h"

#include <algorithm>
#include <cmath>

#include "ripstop/base/units.h"
#include "ripstop/report/figures.h"

namespace ripstop {
namespace {

std::string place(const Vec3& at) {
    return "(" + shown(at.x() / millimetre, 0) + ", " + shown(at.y() / millimetre, 0) + ", " +
           shown(at.z() / millimetre, 0) + ") mm";
}

/// The strain of largest size.
double worst_strain(const Accuracy& a) {
    double worst = 0;
    for (const double strain : {a.warp_strain_min, a.warp_strain_max, a.weft_strain_min, a.weft_strain_max})
        if (std::abs(strain) > std::abs(worst)) worst = strain;
    return worst;
}

std::string findings(const Verdict& verdict) {
    return verdict.findings.empty() ? "none" : failing_codes(verdict);
}

std::string sentence(const FlatTile& tile) {
    const SplitProposal& proposal = *tile.proposal;
    const Accuracy &left = proposal.halves[0].accuracy, &right = proposal.halves[1].accuracy;
    const auto both = [](double before, double one, double other, int decimals) {
        return shown(one / percent, decimals, true) + " and " + shown(other / percent, decimals, true) + " %, not " +
               shown(before / percent, decimals, true) + " %";
    };
    return tile.tile.name + ": of " + std::to_string(proposal.tried) + " seams tried the best runs " +
           proposal.direction + " from " + place(proposal.line.front()) + " to " + place(proposal.line.back()) +
           ";\n  its halves have area " + both(tile.accuracy.area_error, left.area_error, right.area_error, 2) +
           ", largest strain " + both(worst_strain(tile.accuracy), worst_strain(left), worst_strain(right), 1) +
           ";\n  findings left: " + findings(proposal.halves[0].verdict) + " | " +
           findings(proposal.halves[1].verdict) + "\n";
}

std::string more(std::size_t count, const std::string& what) {
    return count > 0 ? "and " + std::to_string(count) + " more " + what + "; report.json has them all\n" : "";
}

}  // namespace

std::string proposals_text(const CutPlan& plan, int max_rows) {
    const std::size_t limit = static_cast<std::size_t>(std::max(0, max_rows));
    std::string splits, merges;
    std::size_t count = 0;
    for (const FlatTile& tile : plan.tiles)
        if (tile.proposal && count++ < limit) splits += sentence(tile);
    for (std::size_t i = 0; i < std::min(limit, plan.merges.size()); ++i) {
        const MergeProposal& merge = plan.merges[i];
        const auto name = [&](int tile) { return plan.tiles[static_cast<std::size_t>(tile)].tile.name; };
        merges += name(merge.tile_a) + " and " + name(merge.tile_b) + " could be one tile: area " +
                  shown(merge.merged.accuracy.area_error / percent, 3, true) + " %, largest strain " +
                  shown(worst_strain(merge.merged.accuracy) / percent, 2, true) + " %\n";
    }
    splits += more(count - std::min(count, limit), "proposals");
    merges += more(plan.merges.size() - std::min(plan.merges.size(), limit), "pairs");
    if (!splits.empty()) splits = "To draw instead (nothing was cut):\n" + splits;
    return splits + merges;
}

}  // namespace ripstop
