#pragma once

#include <vector>

#include "ripstop/mesh/triangle_mesh.h"

namespace ripstop {

/// Of each point the first that lies in its place (equal coordinates, bit by bit but for the sign of zero). O(#V log
/// #V).
std::vector<int> first_in_place(const Points3& points);

/// The mesh with vertices in one place (`first_in_place`) made one, the first of each kept, in their order; triangles
/// as they were. O(#V log #V + #F).
TriangleMesh join_coincident(const TriangleMesh& mesh);

/// The mesh without the vertices that no triangle uses; the others in their order. Requires indices that hold. O(#V +
/// #F).
TriangleMesh drop_unused(const TriangleMesh& mesh);

}  // namespace ripstop
