#pragma once

#include <string>

#include "ripstop/mesh/change/split.h"
#include "ripstop/model/tile/tile.h"

namespace ripstop {

/// Makes a tile of one half of a tile. It has the whole's corners, the two ends of the cut, and the same warp, fabric
/// and compensation; edges are measured on the whole's curves. The cut has its drawn length and no compensation of its
/// own. Throws InputError if the half cannot be a tile (`make_tile`).
Tile make_half_tile(const Tile& whole, const MeshHalf& half, const std::string& name);

}  // namespace ripstop
