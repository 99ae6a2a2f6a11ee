#include "ripstop/report/figures/seam_drift.h"

#include <algorithm>

namespace ripstop {

double drift_at(const SeamWalk& walk, double s) {
    MatchMark before;
    for (std::size_t i = 0; i <= walk.notches.size(); ++i) {
        const MatchMark after = i < walk.notches.size() ? walk.notches[i] : MatchMark{walk.length, walk.mismatch()};
        if (s <= after.at || i == walk.notches.size()) {
            const double step = after.at - before.at;
            return step > 0 ? before.drift + (s - before.at) / step * (after.drift - before.drift) : after.drift;
        }
        before = after;
    }
    return walk.mismatch();
}

std::array<double, 2> share_of_edge(const SeamSide& side, std::size_t part, double drawn) {
    const double share = std::min(1.0, side.parts[part].length / drawn);
    if (side.parts.size() == 1) return {(1 - share) / 2, (1 + share) / 2};
    if (part == 0) return {1 - share, 1};
    return {0, share};
}

}  // namespace ripstop
