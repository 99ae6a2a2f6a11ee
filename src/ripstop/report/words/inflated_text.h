#pragma once

#include <string>

#include "ripstop/model/plan/cut_plan.h"

namespace ripstop {

/// The report on an inflated plan for the terminal: its verdicts (`inflated_says`), then tables of its drawn and
/// inflated sizes, its loads and strength, the causes of its deviation, the rounds of correction and its
/// sensitivity, as far as they exist. Requires `plan.inflated`.
std::string inflated_text(const CutPlan& plan);

}  // namespace ripstop
