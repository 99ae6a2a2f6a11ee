#pragma once

#include "ripstop/model/plan/cut_plan.h"

/// Inflated plans made by hand, for what comes after inflating.
namespace ripstop::testing {

/// `sewn_plan`, blown 10 mm outwards (+z) everywhere: every triangle is stretched by 1 % along the warp, bears 20 N/m along it
/// and 5 N/m across, the first of each tile is wrinkled and the second slack. S1 takes a load tape of 1980 mm; a wire and a tie.
/// 10 m high as drawn, so deviations count from 30 mm on.
CutPlan inflated_plan();

}  // namespace ripstop::testing
