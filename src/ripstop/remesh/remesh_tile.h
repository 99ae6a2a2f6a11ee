#pragma once

#include <vector>

#include "ripstop/model/tile.h"
#include "ripstop/remesh/remesh_disk.h"
#include "ripstop/remesh/smooth_surface.h"

namespace ripstop {

/// A vertex of a tile's new boundary: where it lies on the old one, where it is to lie in space, and how long the curve is
/// from it to the next.
struct BoundaryNode {
    BoundaryPlace place;
    Vec3 position = Vec3::Zero();  ///< [m]
    double length = 0;             ///< [m]
};

/// A tile's new boundary, in its order. It begins where the first chain does, unless that is the only one and has a corner.
struct NewBoundary {
    std::vector<BoundaryNode> nodes;
    std::vector<int> chain_starts;  ///< of each chain, the node it starts with
    BoundarySlopes slopes;          ///< of the old boundary's curves
};

/// The tile on a mesh whose edges are about `edge_length` long [m]: with exactly this boundary, its other vertices on the smooth
/// surface through the old ones (`SmoothSurface`), creases of more than 30 degrees kept. Corners, chains, warp (each triangle
/// has that of the nearest old one), compensation and attributes stay; flat positions that came with the tile are dropped.
///
/// Where that gives no good mesh, smaller edges are tried (0.7 and 0.5 of the length).
/// Throws std::runtime_error, in words that follow the tile's name, where the new mesh is not as good as it must be: no disk,
/// or a triangle turned by more than 60 degrees from the old one beneath it. Requires what `remesh_disk` does.
Tile remesh_tile(const Tile& tile, const NewBoundary& boundary, double edge_length);

/// What `remesh_tile` makes of a new mesh whose first vertices are the boundary's nodes. `origin`: of each triangle the old one
/// beneath it; may be empty for a tile without a warp of each triangle. Throws std::runtime_error where it is no disk.
Tile tile_on_mesh(const Tile& tile, const NewBoundary& boundary, TriangleMesh mesh, const std::vector<int>& origin);

}  // namespace ripstop
