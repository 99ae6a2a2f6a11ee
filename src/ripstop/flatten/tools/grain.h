#pragma once

#include "ripstop/model/tile/tile.h"

namespace ripstop {

/// Rotates and shifts flat positions (#V x 2) so that the tile's warp lies along +x on average, weighted by the area
/// of the triangles on the surface, with the area centroid at the origin. The motion is rigid. If the warp has no
/// mean direction on the cloth (it runs round in a circle) the positions are only centred.
void align_with_grain(const Tile& tile, Points2& positions);

}  // namespace ripstop
