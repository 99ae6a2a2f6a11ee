#pragma once

#include <vector>

#include "ripstop/model/piece/pattern_piece.h"
#include "ripstop/model/plan/cut_plan.h"

namespace ripstop {

/// The lines of a tile on its cloth: each point by the triangle it is nearest to, points left out that the line does
/// without at `chord_error` [m]. Requires flat positions. O(#points x #F).
std::vector<DrawnLine> draw_lines(const FlatTile& tile, double chord_error);

}  // namespace ripstop
