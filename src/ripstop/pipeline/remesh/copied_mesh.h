#pragma once

#include <optional>

#include "ripstop/measure/equal_tiles.h"
#include "ripstop/remesh/remesh_tile.h"

namespace ripstop {

/// A tile on the mesh that was made for the tile it is like (`likeness`), moved over or turned over: so equal tiles
/// stay equal. `made` has the boundary `first`, the tile is to have `boundary`. Its own nodes stay where they are.
/// Nothing where the two boundaries are not the same, vertex by vertex and corner by corner, within 0.15 mm, or each
/// triangle has its own warp.
std::optional<Tile> copied_mesh(const Tile& tile, const NewBoundary& boundary, const Tile& made,
                                const NewBoundary& first, const Likeness& likeness);

}  // namespace ripstop
