#pragma once

#include <optional>

#include "ripstop/model/tile/seam.h"
#include "ripstop/model/tile/tile.h"

namespace ripstop {

/// Welds two neighbours into one tile along a seam. The sides must have the same vertices (within 0.01 mm) and consist
/// of whole edges. Corners are where the new boundary turns; the warp is the mean of both; edges keep their lengths on
/// the seams' curves. Empty if both sides belong to one tile, the fabrics differ, the vertices differ, a tile has
/// compensation, or the warps are more than 15 degrees apart. Throws InputError if the result is not a disk (a second
/// seam between them).
std::optional<Tile> weld_tiles(const Tile& a, const Tile& b, const Seam& seam);

}  // namespace ripstop
