#pragma once

#include <vector>

#include "ripstop/measure/equal_tiles.h"
#include "ripstop/model/plan/cut_plan.h"

namespace ripstop {

/// The flattening of a tile from that of the tile it is like (`likeness.vertex` not empty), as the same method would
/// have made it: turned over where that one is its mirror image, turned by half where the warp points the other way.
Flattening copied_flattening(const FlatTile& first, const Tile& tile, const Likeness& likeness);
Bounds moved_bounds(Bounds bounds, const Likeness& likeness);

/// Sets `equal_to` and `mirrored` of the tiles that are alike and whose pieces are so too: of one colour, their
/// outlines nowhere farther apart than `tolerance` [m], the allowances along them the same, the lines drawn on them at
/// the same places, and their seams beginning and ending there too; the plan must have its seams. Equal tiles between
/// different neighbours may have been cut differently: a kind of tile may have several patterns.
void list_equal_pieces(CutPlan& plan, const std::vector<Likeness>& likeness, double tolerance = 1e-4);

}  // namespace ripstop
