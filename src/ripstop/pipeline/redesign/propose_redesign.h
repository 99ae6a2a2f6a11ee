#pragma once

#include <optional>
#include <vector>

#include "ripstop/base/progress.h"
#include "ripstop/flatten/method.h"
#include "ripstop/model/plan/cut_plan.h"

namespace ripstop {

/// What the designer may draw instead; nothing is cut by us.
///
/// Seam lines tried on a tile: straight on the cloth, along and across the warp, through the tile's middle, thirds,
/// deepest place and most strained places; each is tried by splitting the mesh on it (`split_mesh`) and flattening and
/// judging both halves with the same method and fabric. Proposed is only what helps: both halves are better than the
/// whole (`is_better`), or one can be made. The best has most better halves, then the fewest findings in its worse
/// half, then in both, then the least energy in both. Nothing where no line helps or can be tried: the tile has no
/// sound flattening to draw on, or none divides it in two. Cost: some twenty flattenings of half the size.
std::optional<SplitProposal> propose_split(const FlatTile& tile, const Method& method, const Fabric& fabric,
                                           const Tolerances& tolerances);

/// Neighbours sewn together by one seam along which their meshes have the same vertices, welded there, flattened and
/// judged: the pairs that could be made as one tile, in the order of the seams. The piece must lie on the roll, its
/// warp along it. Left out are pairs of two fabrics, those whose warps differ by more than 15 degrees and those with
/// compensation. One flattening a seam.
std::vector<MergeProposal> propose_merges(const CutPlan& plan, const Method& method, int threads,
                                          const Progress& progress = {});

/// How much may be tried unasked: where more fails, it is the design and not one seam.
struct ProposeLimits {
    int kinds = 12;
    int triangles = 50000;  ///< of them together
};

/// Sets the proposals of the plan's failing tiles: tried on the first of each kind, and moved to those that are cut as
/// it is (`FlatTile::equal_to`). False where they are more than the limits and none was tried.
bool add_proposals(CutPlan& plan, const Method& method, int threads, const ProposeLimits& limits = {},
                   const Progress& progress = {});

}  // namespace ripstop
