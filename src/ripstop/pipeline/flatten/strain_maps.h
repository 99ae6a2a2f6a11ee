#pragma once

#include <vector>

#include "ripstop/model/plan/cut_plan.h"
#include "ripstop/model/plan/strain_map.h"

namespace ripstop {

/// The strains of every tile's triangles (#tiles), for pictures; empty for a tile without flat positions. Tiles are
/// measured on `threads` threads (0: one a core); cost: O(#triangles).
std::vector<StrainMap> measure_strain_maps(const CutPlan& plan, int threads = 0);

}  // namespace ripstop
