#pragma once

#include <array>
#include <vector>

#include "ripstop/mesh/adjacency.h"
#include "ripstop/remesh/remesh_disk.h"

namespace ripstop {

/// The end slopes of the curves that the boundary of a mesh follows: c'(0) and c'(1) of the cubic over each boundary
/// edge [m].
struct BoundarySlopes {
    Points3 start, end;  ///< #boundary x 3
};

/// A smooth surface through the vertices of a disk: PN triangles [VPBM01], one cubic per triangle.
///
///     b_ij = (2 p_i + p_j - ((p_j - p_i) . n_i) n_i) / 3      along an edge from i to j
///     b_111 = E + (E - V) / 2                                  E the mean of the six, V of the three corners
///
/// The normals n are those of a cubic height function through each vertex, fitted to its neighbours within some rings
/// [CP05] (a quadratic if the vertices do not determine a cubic). They differ between the sides of a crease, and a
/// crease stays a polyline. Boundary edges follow the given cubics. The error for a smooth surface sampled at
/// distance h is of fourth order in h; where triangles are coplanar the surface is that plane.
class SmoothSurface {
  public:
    /// O(#F).
    SmoothSurface(const TriangleMesh& mesh, const Adjacency& adjacency, const std::vector<int>& boundary,
                  const std::vector<std::array<int, 2>>& creases, const BoundarySlopes& slopes);

    Vec3 at(const MeshPlace& place) const;

  private:
    const TriangleMesh* mesh_;
    Points3 controls_;  ///< 7 per triangle: b_01, b_10, b_12, b_21, b_20, b_02, b_111
};

}  // namespace ripstop
