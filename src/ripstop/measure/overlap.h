#pragma once

#include <array>
#include <vector>

#include "ripstop/geometry/types.h"

namespace ripstop {

/// The pairs of triangles whose insides lie on one another on the cloth (#V x 2), each as (smaller, larger), sorted.
/// Empty exactly where no cloth would have to be in two places at once. Decided triangle by triangle, so it holds
/// whatever made the flattening; touching along an edge or in a point is no overlap. About O(#F) through a grid.
std::vector<std::array<int, 2>> overlapping_triangles(const Triangles& triangles, const Points2& flat);

}  // namespace ripstop
