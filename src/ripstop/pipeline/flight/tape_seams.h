#pragma once

#include "ripstop/model/flight/flight.h"
#include "ripstop/model/plan/cut_plan.h"

namespace ripstop {

/// Gives a load tape (the seam type `taped`, with the same width) to every seam that runs up the envelope rather than
/// across it. The direction is taken in the plane of the vertical axis through the middle of the bounding box.
/// O(#parts).
void tape_meridians(CutPlan& plan);

/// The seams that take a load tape, as the flight wants them.
void tape_seams(CutPlan& plan, TapedSeams tapes);

}  // namespace ripstop
