#pragma once

#include "ripstop/model/cut_plan.h"

namespace ripstop {

/// Gives every seam that runs up the envelope, in the plane of the vertical axis through its middle rather than across it, a load
/// tape, and takes it from all others. The
/// axis goes through the middle of its box. O(#parts).
void tape_meridians(CutPlan& plan);

}  // namespace ripstop
