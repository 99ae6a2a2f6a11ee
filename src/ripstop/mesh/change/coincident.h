#pragma once

#include <vector>

#include "ripstop/mesh/triangle_mesh.h"

namespace ripstop {

/// The first point at the place of each point (equal coordinates, bit by bit except for the sign of zero). O(#V log
/// #V).
std::vector<int> first_in_place(const Points3& points);

/// Merges vertices at the same place (`first_in_place`) and keeps the first of each, in order. Triangles keep their
/// number and order. O(#V log #V + #F).
TriangleMesh join_coincident(const TriangleMesh& mesh);

/// Removes vertices that no triangle uses and keeps the others in order. Requires valid indices. O(#V + #F).
TriangleMesh drop_unused(const TriangleMesh& mesh);

}  // namespace ripstop
