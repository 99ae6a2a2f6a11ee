#pragma once

#include <array>
#include <vector>

#include "ripstop/mesh/adjacency.h"
#include "ripstop/mesh/triangle_mesh.h"

namespace ripstop {

/// The unit normal of the surface at each corner of each triangle (3 #F x 3, corner k of triangle t in row 3 t + k),
/// outward. A cubic height function through the vertex is fitted to at least 24 vertices within four rings, weighted
/// by distance. If they do not determine it, a quadratic is fitted, and finally the mean of the triangles is taken.
/// Corners on different sides of a crease have separate normals. O(#F).
Points3 corner_normals(const TriangleMesh& mesh, const Adjacency& adjacency,
                       const std::vector<std::array<int, 2>>& creases);

}  // namespace ripstop
