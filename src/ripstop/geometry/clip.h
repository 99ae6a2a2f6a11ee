#pragma once

#include <vector>

#include "ripstop/geometry/types.h"

namespace ripstop {

/// A run of a polyline.
struct LinePart {
    Points2 points;   ///< #P x 2, at least two
    double from = 0;  ///< length of the polyline before it [m]
};

/// What of a polyline (#P x 2) lies in the box, in its order; an end on a side of the box lies on it exactly, so that
/// boxes side by side cut a line at the same point. Parts without length are left out. O(#P).
std::vector<LinePart> clip_to_box(const Points2& line, const Vec2& lower, const Vec2& upper);

/// The polygon as the polyline that ends where it starts.
Points2 closed_line(const Points2& polygon);

}  // namespace ripstop
