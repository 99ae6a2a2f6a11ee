#pragma once

#include "ripstop/geometry/types.h"

namespace ripstop {

/// The triangles of a Delaunay triangulation that lie inside an outline, counter-clockwise. The first `outline`
/// points are the corners of the outline, counter-clockwise; the others lie inside. Returns 0 x 3 if the
/// triangulation lacks an edge of the outline, for instance because a point lies in the circle over that edge. Ties
/// between cocircular points are broken by shifts of 1e-9 of the size.
///
/// Bowyer-Watson insertion from left to right: about O(#points^1.5).
Triangles delaunay_inside(const Points2& points, int outline);

}  // namespace ripstop
