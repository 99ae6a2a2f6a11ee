#pragma once

#include <vector>

#include "ripstop/geometry/types.h"

namespace ripstop {

/// The corner c of a polygon (points in order) from which a fan of triangles (c, i, i + 1) covers it without folding:
/// no triangle faces against the polygon's area vector, sum p_i x p_(i+1) / 2, or against the triangle before it.
/// Returns the first corner whose triangles all have area, so 0 for a strictly convex polygon. If there is none (a
/// corner on a straight side can spoil every fan), returns the one whose smallest triangle is largest.
///
/// Returns -1 if every fan folds over itself or the polygon has no area. A polygon of more than 100 corners is fanned
/// from corner 0 or not at all, which bounds the cost: O(#C) if corner 0 works, otherwise O(#C^2) up to 100 corners.
int fan_corner(const std::vector<Vec3>& polygon);

}  // namespace ripstop
