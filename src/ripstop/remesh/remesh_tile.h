#pragma once

#include <vector>

#include "ripstop/model/tile/tile.h"
#include "ripstop/remesh/remesh_disk.h"
#include "ripstop/remesh/smooth_surface.h"

namespace ripstop {

/// A vertex of a tile's new boundary: its place on the old boundary, its position in space, and the length of the
/// curve to the next vertex.
struct BoundaryNode {
    BoundaryPlace place;
    Vec3 position = Vec3::Zero();  ///< [m]
    double length = 0;             ///< length of the curve to the next [m]
};

/// The new boundary of a tile, in order. It begins at the start of the first chain, unless that is the only chain and
/// has no corner.
struct NewBoundary {
    std::vector<BoundaryNode> nodes;
    std::vector<int> chain_starts;  ///< first node of each chain
    BoundarySlopes slopes;          ///< slopes of the old boundary's curves
};

/// A tile on a new mesh.
struct RemeshedTile {
    Tile tile;
    double distance_max = 0;  ///< largest distance of its vertices from the old triangles [m]
};

/// Remeshes a tile with edges about `edge_length` long [m] and exactly this boundary. If its facets form a row, the
/// result lies on the ruled surface of that row, with vertices on its rulings (`mesh_row`), and stays developable.
/// Otherwise the interior vertices lie on the smooth surface through the old ones (`SmoothSurface`), and creases
/// (`find_creases`) are kept. Corners, chains, warp (each triangle takes that of the nearest old one), compensation
/// and attributes are kept; flat positions from the input are dropped.
///
/// If that gives no good mesh, smaller edges are tried (0.7 and 0.5 of the length), unless they give more than 6,000
/// triangles. Throws std::runtime_error, with a text that follows the tile's name, if the new mesh is not good
/// enough: not a disk, a triangle turned by more than 60 degrees from the old one below it, or over 0.05 % of area
/// beyond what the turns of the old mesh explain (`explained_area`). Same requirements as `remesh_disk`.
RemeshedTile remesh_tile(const Tile& tile, const NewBoundary& boundary, double edge_length);

/// The tile's new boundary as a tile without triangles: enough for `find_seams`.
Tile outline_tile(const Tile& tile, const NewBoundary& boundary);

/// Builds the result of `remesh_tile` from a new mesh whose first vertices are the boundary's nodes. `origin`: the
/// old triangle below each triangle; may be empty unless the tile has a warp per triangle. Throws std::runtime_error
/// if the mesh is not a disk.
Tile tile_on_mesh(const Tile& tile, const NewBoundary& boundary, TriangleMesh mesh, const std::vector<int>& origin);

}  // namespace ripstop
