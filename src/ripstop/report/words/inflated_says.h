#pragma once

#include <string>
#include <vector>

#include "ripstop/model/plan/cut_plan.h"

namespace ripstop {

/// From this share of the drawn height on a deviation is called one, and a cause of it is named as such.
inline constexpr double deviation_share = 0.003;

/// That, of an inflated envelope [m].
double deviation_limit(const Inflated& inflated);

/// Were the patterns corrected for what they do in flight?
bool is_corrected(const CutPlan& plan);

/// What the inflated shape says of the plan, a sentence each, in this order: did it come to rest; is it within
/// `deviation_limit` of the drawn shape; what is too weak; can gas pressure hold the shape, are the patterns wrong,
/// does the cloth stretch too far (each against that limit by itself, as far as the causes are known); is all strong
/// enough; what it carries; does it wrinkle. Requires `plan.inflated`.
std::vector<std::string> inflated_says(const CutPlan& plan);

}  // namespace ripstop
