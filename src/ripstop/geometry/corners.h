#pragma once

#include <vector>

#include "ripstop/geometry/types.h"

namespace ripstop {

/// The corners of a closed line (#P x 2, first point not repeated): the indices of points where it turns by more than
/// `turn` [rad] to either side, in order. Of equal points in a row only the first counts. O(#P).
std::vector<int> sharp_corners(const Points2& polygon, double turn);

}  // namespace ripstop
