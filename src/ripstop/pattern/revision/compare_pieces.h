#pragma once

#include <vector>

#include "ripstop/model/piece/pattern_piece.h"
#include "ripstop/model/piece/piece_change.h"

namespace ripstop {

/// The changes from one revision to the next. Pieces are matched by name. Removed and changed pieces come first,
/// in the order of `before`, then added ones. Lengths that differ by at most `tolerance` [m] are equal. The
/// tolerance of areas is that times the perimeter; of the grain's turn, that over half the piece's size; of its
/// arrow's turn, that over half its length. Edges (`compare_edges`), sew lines and drawn lines are compared after
/// the best motion of the cut line (`fit_outline`); drawn lines, with the nearest of the same name.
std::vector<PieceChange> compare_pieces(const PieceSet& before, const PieceSet& after, double tolerance);

/// The seam types of both sets, by name, that differ in allowance, rows or tape. A type that only one set has
/// shows in the edges that use it.
std::vector<SeamTypeChange> compare_seam_types(const PieceSet& before, const PieceSet& after, double tolerance);

}  // namespace ripstop
