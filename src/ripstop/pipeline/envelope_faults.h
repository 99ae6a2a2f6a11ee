#pragma once

#include "ripstop/model/cut_plan.h"
#include "ripstop/model/envelope_check.h"

namespace ripstop {

/// Takes into a plan's findings what `check_envelope` found that would be cut or sewn wrongly: tiles doubled, turned over,
/// shifted, scaled or apart, under the issue's own code. Openings and loose tiles may be meant, and a unit is only doubted:
/// these are no findings. Values in mm, for `scaled` the ratio; the limit is the seam tolerance, for `scaled` 1.
void add_faults(CutPlan& plan, const EnvelopeCheck& check);

}  // namespace ripstop
