#pragma once

#include <vector>

#include "ripstop/model/plan/cut_plan.h"
#include "ripstop/model/plan/strain_map.h"

namespace ripstop {

/// The strains of each tile's triangles (#tiles), for pictures; empty for a tile without flat positions. `threads` 0:
/// one per core. O(#triangles).
std::vector<StrainMap> measure_strain_maps(const CutPlan& plan, int threads = 0);

}  // namespace ripstop
