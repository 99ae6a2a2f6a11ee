#pragma once

#include <vector>

#include "ripstop/geometry/types.h"

namespace ripstop {

/// The corners of a closed line (#P x 2, the first point not repeated): the points, in order, where it turns by more
/// than `turn` [rad], to either side. A point repeated in a row counts once, the first time. O(#P).
std::vector<int> sharp_corners(const Points2& polygon, double turn);

}  // namespace ripstop
