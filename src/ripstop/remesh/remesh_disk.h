#pragma once

#include <array>
#include <string>
#include <vector>

#include "ripstop/mesh/triangle_mesh.h"
#include "ripstop/model/tile/boundary_place.h"

namespace ripstop {

/// A place on a mesh: a triangle and the weights of its corners.
struct MeshPlace {
    int triangle = 0;
    Vec3 weights = Vec3::Zero();  ///< >= 0, they sum to 1
};

/// Another triangulation of a disk.
struct DiskRemesh {
    TriangleMesh mesh;              ///< its boundary vertices first, in the order of the places asked for
    std::vector<MeshPlace> places;  ///< of each vertex, on the disk as it was; of the boundary ones only the first
                                    ///< count means nothing: they lie where they were asked for
    std::vector<int> origin;        ///< of each triangle, the old triangle nearest to its middle
};

/// Triangulates a disk anew: its boundary runs straight from each of `places` to the next, its edges are about
/// `edge_length` long, its other vertices lie on the old triangles. Edges in `creases` stay edges, split where they are
/// longer. Isotropic remeshing after Botsch and Kobbelt [BK04]: edges split, collapsed and flipped, vertices moved
/// along the surface, by CGAL's polygon mesh processing; then edges across the disk between two boundary vertices are
/// split or flipped away, since no flattening can bend them.
///
/// Requires a disk (`require_disk`) with that boundary, at least three places in its order, none of them farther apart
/// than 4/3 of the edge length. Throws std::runtime_error in words where no such mesh is found. About 0.1 s for 1,000
/// triangles.
DiskRemesh remesh_disk(const TriangleMesh& mesh, const std::vector<int>& boundary,
                       const std::vector<BoundaryPlace>& places, const std::vector<std::array<int, 2>>& creases,
                       double edge_length);

/// Was the library built with CGAL? Without it `remesh_disk` always throws.
bool can_remesh();

}  // namespace ripstop
