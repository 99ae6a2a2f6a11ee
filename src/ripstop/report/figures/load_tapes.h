#pragma once

#include <vector>

#include "ripstop/model/plan/cut_plan.h"

namespace ripstop {

/// For each seam of an inflated plan, the index of its load tape in `Inflated::tapes`; -1 if it has none. In an
/// envelope of equal sectors only one sector has tapes; each seam of the others is matched with its rotated copy
/// by place: height, distance from the axis, angle within the sector. Requires `plan.inflated`. O(#seams x
/// #tapes).
std::vector<int> tapes_of_seams(const CutPlan& plan);

/// For each seam, the length at which its load tape is cut, at rest [m]: its length as drawn, times its
/// `tape_factors`, less the foreshortening it was inflated with. NaN if it has no tape, or if the tapes are not
/// known yet.
std::vector<double> tape_cut_lengths(const CutPlan& plan);

}  // namespace ripstop
