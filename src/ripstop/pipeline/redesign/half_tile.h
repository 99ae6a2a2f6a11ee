#pragma once

#include <string>

#include "ripstop/mesh/change/split.h"
#include "ripstop/model/tile/tile.h"

namespace ripstop {

/// The half of a tile as a tile: with the corners of the whole and the two ends of the cut, the same warp, fabric and
/// compensation, and edges measured on the curves of the whole's. The cut is as long as drawn and sewn without
/// compensation of its own. Throws InputError where the half cannot be a tile (`make_tile`).
Tile make_half_tile(const Tile& whole, const MeshHalf& half, const std::string& name);

}  // namespace ripstop
