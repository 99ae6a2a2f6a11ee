#pragma once

#include <array>
#include <vector>

#include "ripstop/geometry/types.h"

namespace ripstop {

/// The pairs of triangles whose interiors overlap on the cloth (#V x 2), each as (smaller, larger), sorted. Empty if
/// and only if the map is injective. The test compares triangles, so it holds for any flattening method; a common
/// edge or point is not an overlap. About O(#F) by a grid.
std::vector<std::array<int, 2>> overlapping_triangles(const Triangles& triangles, const Points2& flat);

}  // namespace ripstop
