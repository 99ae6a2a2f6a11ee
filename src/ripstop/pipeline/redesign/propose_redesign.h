#pragma once

#include <optional>
#include <vector>

#include "ripstop/base/progress.h"
#include "ripstop/flatten/method.h"
#include "ripstop/model/plan/cut_plan.h"

namespace ripstop {

/// Proposes a seam on a tile for the designer to draw; the program itself never cuts a tile.
///
/// The candidates are straight lines on the cloth, along and across the warp, through the tile's middle, thirds,
/// deepest place and most strained places. Each one is tried: the mesh is split on it (`split_mesh`), and both halves
/// are flattened and judged with the same method and fabric. A candidate counts if both halves are better than the
/// whole (`is_better`), or if one of them can be made. The best one has the most better halves, then the fewest
/// findings in its worse half, then in both, then the least energy in both. Empty if no line helps or none can be
/// tried: the tile has no sound flattening, or no line divides it in two. Costs some twenty flattenings of half the
/// size.
std::optional<SplitProposal> propose_split(const FlatTile& tile, const Method& method, const Fabric& fabric,
                                           const Tolerances& tolerances);

/// Finds pairs of tiles that could be made as one tile, in the order of the seams. Each pair shares exactly one seam,
/// along which the meshes have the same vertices; it is welded there, flattened and judged. The piece must fit on the
/// roll with its warp along it. Pairs are skipped if their fabrics differ, their warps differ by more than 15 degrees,
/// or they have compensation. Costs one flattening per seam.
std::vector<MergeProposal> propose_merges(const CutPlan& plan, const Method& method, int threads,
                                          const Progress& progress = {});

/// Limits for automatic trials: if more tiles fail, the design is at fault, not a single seam.
struct ProposeLimits {
    int kinds = 12;
    int triangles = 50000;  ///< of all tried tiles together
};

/// Sets the proposals of the plan's failing tiles: tries them on the first tile of each kind and transfers them to the
/// tiles that are cut the same (`FlatTile::equal_to`). Returns false if the limits are exceeded; then none is tried.
bool add_proposals(CutPlan& plan, const Method& method, int threads, const ProposeLimits& limits = {},
                   const Progress& progress = {});

}  // namespace ripstop
