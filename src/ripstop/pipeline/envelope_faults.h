#pragma once

#include "ripstop/model/cut_plan.h"
#include "ripstop/model/envelope_check.h"

namespace ripstop {

/// Takes into a plan's findings what `check_envelope` found that would be cut or sewn wrongly: tiles doubled, turned over,
/// shifted, scaled or apart, surfaces that are no tiles, a wrong unit, coordinates too coarse, under the issue's own code.
/// Openings and loose tiles may be meant: these are no findings. Values in mm, for `scaled` the ratio; the limit is the
/// issue's own, else the seam tolerance, for `scaled` 1; of no tile one too many.
void add_faults(CutPlan& plan, const EnvelopeCheck& check);

}  // namespace ripstop
