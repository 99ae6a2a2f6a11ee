#pragma once

#include <vector>

#include "ripstop/mesh/sight_lines.h"
#include "ripstop/model/tile/tile.h"

namespace ripstop {

/// How much more open sky one side of a tile sees than the other, 0 to 1. It is 1 for the skin of a closed shape.
/// It is 0 for tiles with the inside on both sides (ribs, diaphragms) or the outside on both sides (fins). From
/// eight of the tile's triangles, 32 fixed directions are tested; the value is the difference between the shares
/// of directions without cloth on the two sides. It depends neither on the order of the tiles nor on which side is
/// up. `cloth` holds all tiles.
double one_sidedness(const Tile& tile, const SightLines& cloth);

/// One-sidedness of each tile that is `wanted`; 0 for the others. Parallel. O(#F log #F) plus the lines of sight.
std::vector<double> one_sidedness(const std::vector<Tile>& tiles, const std::vector<char>& wanted);

}  // namespace ripstop
