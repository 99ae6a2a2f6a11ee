#pragma once

#include "ripstop/model/plan/cut_plan.h"
#include "ripstop/model/plan/symmetry.h"

namespace ripstop {

/// The equal sectors of a plan about a vertical axis, as many as there are: every tile is one of the first sector
/// turned, vertex by vertex to a micrometre, with the same flat shape to 1e-9 and seams of the same kind. One sector
/// where there is no such symmetry.
Symmetry find_symmetry(const CutPlan& plan);

}  // namespace ripstop
