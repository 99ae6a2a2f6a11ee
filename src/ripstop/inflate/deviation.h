#pragma once

#include "ripstop/model/flight/inflated.h"
#include "ripstop/model/plan/cut_plan.h"

namespace ripstop {

/// Fills in how far each tile's `positions` are from the drawn envelope (`InflatedTile::deviation`, `off`) and the
/// whole's `Inflated::off`: distance to the nearest point of any drawn tile, positive outside; root mean squares by the
/// area at each vertex. In parallel; for each vertex the tiles nearer than its own drawn place are searched, O(#F) of
/// each.
void measure_deviation(const CutPlan& plan, int threads, Inflated& inflated);

}  // namespace ripstop
