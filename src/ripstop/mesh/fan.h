#pragma once

#include <vector>

#include "ripstop/geometry/types.h"

namespace ripstop {

/// The corner c of a polygon (its points in order) from which a fan of triangles (c, i, i + 1) covers it without
/// folding: no triangle faces against the polygon's area vector, sum p_i x p_(i+1) / 2, or against the triangle before
/// it. It is the first corner whose triangles all have area, so 0 for a strictly convex polygon; where there is none (a
/// corner on a straight side can be in the way from everywhere), the one whose thinnest triangle is largest.
///
/// -1 where every fan folds over itself, or the polygon has no area. A polygon of more than 100 corners is fanned from
/// corner 0 or not at all, which bounds the cost: O(#C) where corner 0 will do, O(#C^2) up to 100 corners otherwise.
int fan_corner(const std::vector<Vec3>& polygon);

}  // namespace ripstop
