#pragma once

#include "ripstop/model/flight/flight.h"
#include "ripstop/model/plan/cut_plan.h"

namespace ripstop {

/// Gives every seam that runs up the envelope, in the plane of the vertical axis through the middle of its box rather
/// than across it, a load tape: the type `taped`, as wide as it was. O(#parts).
void tape_meridians(CutPlan& plan);

/// The seams that take a load tape, as the flight wants them.
void tape_seams(CutPlan& plan, TapedSeams tapes);

}  // namespace ripstop
