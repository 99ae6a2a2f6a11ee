#pragma once

#include <optional>

#include "ripstop/remesh/facet_row.h"
#include "ripstop/remesh/remesh_tile.h"

namespace ripstop {

/// A mesh of a row of facets that unrolls flat as they do.
struct RowMesh {
    TriangleMesh mesh;        ///< its boundary vertices first, in the order of the nodes
    std::vector<int> origin;  ///< of each triangle, the old triangle nearest to its middle
    double distance_max = 0;  ///< of its vertices from the polyhedron [m]
};

/// Triangles of the row's smooth surface within the new boundary. Inside lie rungs from side a to side b, straight as
/// the surface is, each with vertices at even shares; so a column between two of them is flat. As many rungs as the
/// side with more nodes has, so many vertices on each that the cells are about square. Between them and the boundary
/// triangles go from node to node. Nothing where a corner of the row is no node, or a triangle would be turned from the
/// facet it lies on by more than 60 degrees. O(#nodes #cells + #F).
std::optional<RowMesh> mesh_row(const Tile& tile, const FacetRow& row, const NewBoundary& boundary);

}  // namespace ripstop
