#pragma once

#include <vector>

#include "ripstop/model/tile/tile.h"
#include "ripstop/remesh/remesh_disk.h"
#include "ripstop/remesh/smooth_surface.h"

namespace ripstop {

/// A vertex of a tile's new boundary: where it lies on the old one, where it is to lie in space, and how long the curve
/// is from it to the next.
struct BoundaryNode {
    BoundaryPlace place;
    Vec3 position = Vec3::Zero();  ///< [m]
    double length = 0;             ///< [m]
};

/// A tile's new boundary, in its order. It begins where the first chain does, unless that is the only one and has a
/// corner.
struct NewBoundary {
    std::vector<BoundaryNode> nodes;
    std::vector<int> chain_starts;  ///< of each chain, the node it starts with
    BoundarySlopes slopes;          ///< of the old boundary's curves
};

/// A tile on another mesh.
struct RemeshedTile {
    Tile tile;
    double distance_max = 0;  ///< of its vertices from the triangles as they were [m]
};

/// The tile on a mesh whose edges are about `edge_length` long [m], with exactly this boundary. Where its facets lie in
/// a row it is the ruled surface of that row, on rungs along its rulings (`mesh_row`): it stays developable. Else its
/// other vertices lie on the smooth surface through the old ones (`SmoothSurface`), creases (`find_creases`) kept.
/// Corners, chains, warp (each triangle has that of the nearest old one), compensation and attributes stay; flat
/// positions that came with the tile are dropped.
///
/// Where that gives no good mesh, smaller edges are tried (0.7 and 0.5 of the length), unless they give more than 6,000
/// triangles. Throws std::runtime_error, in words that follow the tile's name, where the new mesh is not as good as it
/// must be: no disk, a triangle turned by more than 60 degrees from the old one beneath it, or more than 0.05 % of area
/// beyond what the turns of the old mesh explain (`explained_area`). Requires what `remesh_disk` does.
RemeshedTile remesh_tile(const Tile& tile, const NewBoundary& boundary, double edge_length);

/// The tile's new boundary as a tile without triangles: enough for `find_seams`.
Tile outline_tile(const Tile& tile, const NewBoundary& boundary);

/// What `remesh_tile` makes of a new mesh whose first vertices are the boundary's nodes. `origin`: of each triangle the
/// old one beneath it; may be empty for a tile without a warp of each triangle. Throws std::runtime_error where it is
/// no disk.
Tile tile_on_mesh(const Tile& tile, const NewBoundary& boundary, TriangleMesh mesh, const std::vector<int>& origin);

}  // namespace ripstop
