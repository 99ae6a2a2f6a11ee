#pragma once

#include "ripstop/geometry/types.h"

namespace ripstop {

/// Simplifies a polyline by Douglas-Peucker [DP73]: it keeps both ends, and every dropped point lies within
/// `tolerance` [m] of the result. A closed line (first point equal to the last) keeps its furthest point too. O(#P
/// log #P), O(#P2) at worst.
Points2 simplified(const Points2& line, double tolerance);

}  // namespace ripstop
