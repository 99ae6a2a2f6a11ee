#pragma once

#include "ripstop/geometry/types.h"

namespace ripstop {

/// The triangles of the Delaunay triangulation of points in the plane that lie inside an outline, counter-clockwise:
/// the first `outline` points in their order are its corners, counter-clockwise, the others lie inside. Nothing (0 x 3)
/// where the triangulation does not have every edge of the outline, as where a point lies nearer to one than half its
/// length and within the circle over it. Points on one circle are told apart by a shift of 1e-9 of the size.
///
/// Bowyer and Watson's insertion, from left to right: about O(#points^1.5).
Triangles delaunay_inside(const Points2& points, int outline);

}  // namespace ripstop
