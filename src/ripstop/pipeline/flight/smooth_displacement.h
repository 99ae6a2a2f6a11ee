#pragma once

#include <vector>

#include "ripstop/model/flight/rigging.h"
#include "ripstop/model/plan/cut_plan.h"

namespace ripstop {

/// The displacement of the sewn envelope closest to `displacement` (of each tile #V x 3 [m]) that does not change
/// abruptly from place to place: on the drawn surface, with the sides of each seam moving as one,
///
///     min_d'  int |d' - d|^2 + length^2 |grad d'|^2
///
/// a screened Laplacian whose solution forgets what is narrower than `length` [m]. `rigging`: as the envelope was sewn.
/// One sparse factorisation. Throws InputError as `sew` does.
std::vector<Points3> smooth_displacement(const CutPlan& plan, const Rigging& rigging,
                                         const std::vector<Points3>& displacement, double length);

}  // namespace ripstop
