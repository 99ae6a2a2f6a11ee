#pragma once

#include "ripstop/model/plan/cut_plan.h"
#include "ripstop/model/plan/symmetry.h"

namespace ripstop {

/// Finds the largest number of equal sectors of a plan about a vertical axis. Every tile is a rotated tile of the first
/// sector, with vertices within a micrometre, the same flat shape to 1e-9, and seams of the same kind. One sector if
/// there is no such symmetry.
Symmetry find_symmetry(const CutPlan& plan);

}  // namespace ripstop
