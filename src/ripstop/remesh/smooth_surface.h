#pragma once

#include <array>
#include <vector>

#include "ripstop/mesh/adjacency.h"
#include "ripstop/remesh/remesh_disk.h"

namespace ripstop {

/// The slopes of the curves that the boundary of a mesh follows: of each boundary edge, c'(0) and c'(1) of its cubic
/// [m].
struct BoundarySlopes {
    Points3 start, end;  ///< #boundary x 3
};

/// A smooth surface through the vertices of a disk: PN triangles [VPBM01], a cubic a triangle.
///
///     b_ij = (2 p_i + p_j - ((p_j - p_i) . n_i) n_i) / 3      along an edge from i to j
///     b_111 = E + (E - V) / 2                                  E the mean of the six, V of the three corners
///
/// Normals n are those of a cubic height function (a quadratic where the vertices do not determine it) through each
/// vertex and fitted to its neighbours within some rings [CP05]; they differ from one side of a crease to the other,
/// and a crease stays a polyline. Boundary edges follow the given cubics. Of a smooth surface sampled at distance h it
/// is true to the fourth order of h; where triangles are in one plane it is that plane.
class SmoothSurface {
  public:
    /// O(#F).
    SmoothSurface(const TriangleMesh& mesh, const Adjacency& adjacency, const std::vector<int>& boundary,
                  const std::vector<std::array<int, 2>>& creases, const BoundarySlopes& slopes);

    Vec3 at(const MeshPlace& place) const;

  private:
    const TriangleMesh* mesh_;
    Points3 controls_;  ///< 7 a triangle: b_01, b_10, b_12, b_21, b_20, b_02, b_111
};

}  // namespace ripstop
