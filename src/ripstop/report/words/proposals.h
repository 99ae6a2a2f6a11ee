#pragma once

#include <string>
#include <vector>

#include "ripstop/model/plan/cut_plan.h"

namespace ripstop {

/// The tiles of one pattern share a proposal, each in its own place.
struct ProposedKind {
    std::size_t tile = 0;  ///< index of the first of them in `CutPlan::tiles`
    std::size_t count = 1;
};
std::vector<ProposedKind> proposed_kinds(const CutPlan& plan);

/// The result of a tile's proposal: `both halves can be made then`, …
std::string halves_words(const FlatTile& tile);

/// Alternatives for the designer, one sentence each: the seams that would help most in tiles that cannot be made,
/// and the neighbours that could be one tile, at most `max_rows` of either. Empty if there are none.
std::string proposals_text(const CutPlan& plan, int max_rows = 12);

}  // namespace ripstop
