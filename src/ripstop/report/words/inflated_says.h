#pragma once

#include <string>
#include <vector>

#include "ripstop/model/plan/cut_plan.h"

namespace ripstop {

/// A deviation above this share of the drawn height is called one, and its causes are named.
inline constexpr double deviation_share = 0.003;

/// The same limit for an inflated envelope [m].
double deviation_limit(const Inflated& inflated);

/// True if the patterns were corrected for their deformation in flight.
bool is_corrected(const CutPlan& plan);

/// True if an inflated plan is at rest, matches the drawn shape within `deviation_limit`, and is strong enough.
bool flies_as_drawn(const CutPlan& plan);

/// The verdicts of the inflated shape, one sentence each, in this order. Is it at rest? Is it within
/// `deviation_limit` of the drawn shape? What is too weak? Can gas pressure hold the shape, are the patterns
/// wrong, does the cloth stretch too far (each compared with that limit separately, as far as the causes are
/// known)? Is everything strong enough? What does it carry? Does it wrinkle? Requires `plan.inflated`.
std::vector<std::string> inflated_says(const CutPlan& plan);

}  // namespace ripstop
