#pragma once

#include <vector>

#include "ripstop/model/piece/pattern_piece.h"
#include "ripstop/model/plan/cut_plan.h"

namespace ripstop {

/// The lines of a tile on its cloth. Each point is mapped by the triangle closest to it; points that the line can
/// do without at `chord_error` [m] are dropped. Requires flat positions. O(#points x #F).
std::vector<DrawnLine> draw_lines(const FlatTile& tile, double chord_error);

}  // namespace ripstop
