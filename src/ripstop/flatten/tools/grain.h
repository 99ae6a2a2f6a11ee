#pragma once

#include "ripstop/model/tile/tile.h"

namespace ripstop {

/// Turns and shifts flat positions (#V x 2) so that the tile's warp lies along +x on average, each triangle weighted by
/// its area on the surface, and the area centre at the origin. Rigid: nothing is stretched or mirrored. Where the warp
/// has no average direction on the cloth (it runs round in a circle) the positions are only centred.
void align_with_grain(const Tile& tile, Points2& positions);

}  // namespace ripstop
