#pragma once

#include <optional>

#include "ripstop/measure/equal_tiles.h"
#include "ripstop/remesh/remesh_tile.h"

namespace ripstop {

/// Gives a tile the mesh made for an equal tile (`likeness`), moved or mirrored, so equal tiles stay equal. `made` has
/// the boundary `first`, and the new tile gets `boundary`, whose nodes do not move. Empty if the boundaries differ in a
/// vertex or corner by more than 0.15 mm, or if each triangle has its own warp.
std::optional<Tile> copied_mesh(const Tile& tile, const NewBoundary& boundary, const Tile& made,
                                const NewBoundary& first, const Likeness& likeness);

}  // namespace ripstop
