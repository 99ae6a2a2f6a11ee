#pragma once

#include <string>

#include "ripstop/model/plan/cut_plan.h"

namespace ripstop {

/// An inflated plan for the terminal: what it says (`inflated_says`), then tables of its sizes drawn and inflated, of
/// what it bears and how strong it is, of the causes of its deviation, of the rounds of correction and of its
/// sensitivity, each as far as there is one. Requires `plan.inflated`.
std::string inflated_text(const CutPlan& plan);

}  // namespace ripstop
