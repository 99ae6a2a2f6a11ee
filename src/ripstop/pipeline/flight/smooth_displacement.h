#pragma once

#include <vector>

#include "ripstop/model/flight/rigging.h"
#include "ripstop/model/plan/cut_plan.h"

namespace ripstop {

/// The smooth displacement of the sewn envelope that is closest to `displacement` (of each tile #V x 3 [m]). It is
/// computed on the drawn surface, with both sides of each seam moving together:
///
///     min_d'  int |d' - d|^2 + length^2 |grad d'|^2
///
/// This is a screened Laplacian: it removes features narrower than `length` [m]. `rigging`: as the envelope was sewn.
/// Costs one sparse factorisation. Throws InputError as `sew` does.
std::vector<Points3> smooth_displacement(const CutPlan& plan, const Rigging& rigging,
                                         const std::vector<Points3>& displacement, double length);

}  // namespace ripstop
