#pragma once

#include <vector>

#include "ripstop/measure/equal_tiles.h"
#include "ripstop/model/plan/cut_plan.h"

namespace ripstop {

/// Derives the flattening of a tile from that of an equal tile (`likeness.vertex` must not be empty), as the same
/// method would compute it: mirrored if the tile is a mirror image, rotated by 180 degrees if the warp points the other
/// way.
Flattening copied_flattening(const FlatTile& first, const Tile& tile, const Likeness& likeness);
Bounds moved_bounds(Bounds bounds, const Likeness& likeness);

/// Sets `equal_to` and `mirrored` for equal tiles whose pieces are equal as well: same colour, outlines within
/// `tolerance` [m], same allowances along them, same lines at the same places, and seams that begin and end at the same
/// places. The plan must have its seams. Equal tiles with different neighbours may be cut differently, so one kind of
/// tile may have several patterns.
void list_equal_pieces(CutPlan& plan, const std::vector<Likeness>& likeness, double tolerance = 1e-4);

}  // namespace ripstop
