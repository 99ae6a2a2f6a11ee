#pragma once

#include <optional>

#include "ripstop/model/tile/seam.h"
#include "ripstop/model/tile/tile.h"

namespace ripstop {

/// Two neighbours as one tile, welded along a seam whose sides have the same vertices (within 0.01 mm) and whole edges.
/// Corners are where its boundary turns; the warp is the mean of both; edges keep their lengths on the seams' curves.
/// Nothing where the tiles are one, are not of one fabric, do not have the same vertices, are compensated, or have
/// warps more than 15 degrees apart. Throws InputError where together they are no disk (a second seam between them).
std::optional<Tile> weld_tiles(const Tile& a, const Tile& b, const Seam& seam);

}  // namespace ripstop
