#pragma once

#include <vector>

#include "ripstop/model/plan/cut_plan.h"

namespace ripstop {

/// Of each seam of an inflated plan: which of `Inflated::tapes` is its load tape, -1 where it takes none. Of an
/// envelope of equal sectors only one has tapes of its own; the seams of the others have those of the seam they are
/// turned from, found by place: height, distance from the axis, angle within the sector. Requires `plan.inflated`.
/// O(#seams x #tapes).
std::vector<int> tapes_of_seams(const CutPlan& plan);

/// Of each seam: how long its load tape is cut, at rest [m]: its length as drawn, times its `tape_factors`, shorter by
/// the foreshortening it was inflated with. Not a number where it takes none, or where nothing is known of tapes yet.
std::vector<double> tape_cut_lengths(const CutPlan& plan);

}  // namespace ripstop
