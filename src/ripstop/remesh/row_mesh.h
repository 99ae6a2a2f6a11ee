#pragma once

#include <optional>

#include "ripstop/remesh/facet_row.h"
#include "ripstop/remesh/remesh_tile.h"

namespace ripstop {

/// A mesh of a facet row that is as developable as the row.
struct RowMesh {
    TriangleMesh mesh;        ///< its boundary vertices come first, in the order of the nodes
    std::vector<int> origin;  ///< for each triangle, the old triangle nearest to its centroid
    double distance_max = 0;  ///< largest distance of its vertices from the polyhedron [m]
};

/// Meshes the row's smooth surface within the new boundary. Straight rungs run from side a to side b, as the surface
/// is ruled, each with evenly spaced vertices, so the column between two rungs is flat. There are as many rungs as
/// the side with more nodes has, and enough vertices on each for about square cells. Between rungs and boundary,
/// triangles go from node to node. Empty if a corner of the row is not a node, or if a triangle would turn from its
/// facet by more than 60 degrees. O(#nodes #cells + #F).
std::optional<RowMesh> mesh_row(const Tile& tile, const FacetRow& row, const NewBoundary& boundary);

}  // namespace ripstop
