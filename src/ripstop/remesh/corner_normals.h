#pragma once

#include <array>
#include <vector>

#include "ripstop/mesh/adjacency.h"
#include "ripstop/mesh/triangle_mesh.h"

namespace ripstop {

/// The normal of the surface at each corner of each triangle (3 #F x 3, corner k of triangle t in row 3 t + k), of unit
/// length, outward: of a cubic height function through the vertex, fitted to 24 or more vertices within four rings,
/// weighted by distance; a quadratic, at last the mean of the triangles, where they do not determine it. Corners on
/// different sides of a crease have their own. O(#F).
Points3 corner_normals(const TriangleMesh& mesh, const Adjacency& adjacency,
                       const std::vector<std::array<int, 2>>& creases);

}  // namespace ripstop
