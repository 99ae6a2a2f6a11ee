#pragma once

#include <string>
#include <vector>

#include "ripstop/model/plan/cut_plan.h"

/// Seams and flat tiles made by hand, for the steps after finding seams.
namespace ripstop::testing {

/// One side of a seam: the whole edges `from` to `to` - 1 of the chain, as long as drawn.
SeamSide run_of_chain(const Envelope& envelope, int tile, int chain, int from, int to);

/// The total length of the parts.
double length(const SeamSide& side);

/// The tile as if a method had flattened it to these positions: unjudged, with `on_curve` as `edges_on_curve`.
FlatTile flattened(const Tile& tile, const Points2& positions, bool on_curve = false);

/// The tiles of an envelope projected to their x and y.
std::vector<FlatTile> laid_flat(const Envelope& envelope);

/// Three sheets, sewn and walked: `left`, 1 m x 2 m, and on its right side `low` and `high`, 1 m x 1 m each.
/// `high` is cut 2 mm too high, so of the seams S1 (left, low), S2 (left, high) and S3 (low, high) the second
/// fails. Tiles have no findings.
CutPlan sewn_plan();

/// Two sheets of 1 m x 1 m, `left` and `right`, whose seam has edges of 100 and 900 mm on both sides. `right` is
/// cut 1 mm too high, which the seam's limit barely allows.
CutPlan unevenly_meshed_plan();

}  // namespace ripstop::testing
