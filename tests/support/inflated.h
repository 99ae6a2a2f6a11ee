#pragma once

#include "ripstop/model/plan/cut_plan.h"

/// Inflated plans made by hand, for the steps after inflating.
namespace ripstop::testing {

/// `sewn_plan`, inflated by 10 mm outwards (+z) everywhere. Every triangle is stretched by 1 % along the warp and
/// carries 20 N/m along it and 5 N/m across; the first of each tile is wrinkled and the second slack. S1 has a
/// load tape of 1980 mm; there is a wire and a tie. It is drawn 10 m high, so deviations count from 30 mm.
CutPlan inflated_plan();

}  // namespace ripstop::testing
