#pragma once

#include <string>
#include <vector>

#include "ripstop/model/plan/cut_plan.h"

namespace ripstop {

/// Tiles with a proposal that are cut by one pattern have the same one, each where it lies.
struct ProposedKind {
    std::size_t tile = 0;  ///< in `CutPlan::tiles`: the first of them
    std::size_t count = 1;
};
std::vector<ProposedKind> proposed_kinds(const CutPlan& plan);

/// `both halves can be made then`, …: what a tile's proposal comes to.
std::string halves_words(const FlatTile& tile);

/// What the designer may draw instead, a sentence each: the seams that would help most in tiles that cannot be made,
/// and the neighbours that could be one tile, at most `max_rows` of either. Empty where nothing is proposed.
std::string proposals_text(const CutPlan& plan, int max_rows = 12);

}  // namespace ripstop
