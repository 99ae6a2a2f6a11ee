#pragma once

#include <vector>

#include "ripstop/mesh/sight_lines.h"
#include "ripstop/model/tile/tile.h"

namespace ripstop {

/// How much more of the open one side of a tile sees than the other, 0 to 1: 1 for the skin of something closed, 0 for
/// what has the inside on both sides, as ribs and diaphragms have, or the outside, as fins have. Of 32 directions fixed
/// in space, from eight of the tile's triangles, the share that meets no cloth on the one side less that on the other.
/// Neither the order of the tiles nor which side is up plays a part. `cloth`: all tiles.
double one_sidedness(const Tile& tile, const SightLines& cloth);

/// The same of the tiles with `wanted`; 0 of the others. In parallel; O(#F log #F) and the lines of the tiles.
std::vector<double> one_sidedness(const std::vector<Tile>& tiles, const std::vector<char>& wanted);

}  // namespace ripstop
