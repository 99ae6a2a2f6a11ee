#pragma once

#include <array>
#include <string>
#include <vector>

#include "ripstop/mesh/triangle_mesh.h"
#include "ripstop/model/tile/boundary_place.h"

namespace ripstop {

/// A place on a mesh: a triangle and barycentric coordinates.
struct MeshPlace {
    int triangle = 0;
    Vec3 weights = Vec3::Zero();  ///< >= 0, with sum 1
};

/// A new triangulation of a disk.
struct DiskRemesh {
    TriangleMesh mesh;              ///< its boundary vertices come first, in the order of the requested places
    std::vector<MeshPlace> places;  ///< place of each vertex on the old disk; meaningless for boundary vertices, which
                                    ///< lie where they were requested
    std::vector<int> origin;        ///< for each triangle, the old triangle nearest to its centroid
};

/// Remeshes a disk. Its boundary runs straight from each of `places` to the next, its edges are about `edge_length`
/// long, and its other vertices lie on the old triangles. Edges in `creases` are kept and split if they are longer.
/// Isotropic remeshing after Botsch and Kobbelt [BK04] by CGAL's polygon mesh processing: edges are split, collapsed
/// and flipped, and vertices move tangentially. Then interior edges between two boundary vertices are split or
/// flipped, because no flattening can bend them.
///
/// Requires a disk (`require_disk`) with that boundary, and at least three places in its order, none farther apart
/// than 4/3 of the edge length. Throws std::runtime_error with a readable message if no such mesh is found. About 0.1
/// s for 1,000 triangles.
DiskRemesh remesh_disk(const TriangleMesh& mesh, const std::vector<int>& boundary,
                       const std::vector<BoundaryPlace>& places, const std::vector<std::array<int, 2>>& creases,
                       double edge_length);

/// Whether the library was built with CGAL. Without it `remesh_disk` always throws.
bool can_remesh();

}  // namespace ripstop
