#pragma once

#include "ripstop/model/flight/inflated.h"
#include "ripstop/model/plan/cut_plan.h"

namespace ripstop {

/// Computes the deviation of each tile's `positions` from the drawn envelope (`InflatedTile::deviation`, `off`) and
/// the total `Inflated::off`: the distance to the nearest point of any drawn tile, positive outside. Root mean
/// squares are weighted by the area at each vertex. Parallel. For each vertex, tiles closer than its own drawn place
/// are searched, in O(#F) each.
void measure_deviation(const CutPlan& plan, int threads, Inflated& inflated);

}  // namespace ripstop
