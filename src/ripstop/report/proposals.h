#pragma once

#include <string>

#include "ripstop/model/cut_plan.h"

namespace ripstop {

/// What the designer may draw instead, a sentence each: the seams that would help most in tiles that cannot be made, and
/// the neighbours that could be one tile, at most `max_rows` of either. Empty where nothing is proposed.
std::string proposals_text(const CutPlan& plan, int max_rows = 12);

}  // namespace ripstop
