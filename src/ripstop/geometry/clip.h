#pragma once

#include <vector>

#include "ripstop/geometry/types.h"

namespace ripstop {

/// A part of a polyline.
struct LinePart {
    Points2 points;   ///< #P x 2, at least two
    double from = 0;  ///< length of the polyline before this part [m]
};

/// Clips a polyline (#P x 2) to the box and returns its parts in order. An end on a side of the box lies on it
/// exactly, so adjacent boxes cut a line at the same point. Parts without length are dropped. O(#P).
std::vector<LinePart> clip_to_box(const Points2& line, const Vec2& lower, const Vec2& upper);

/// The polygon as a polyline that repeats its first point at the end.
Points2 closed_line(const Points2& polygon);

}  // namespace ripstop
