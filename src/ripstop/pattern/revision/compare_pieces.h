#pragma once

#include <vector>

#include "ripstop/model/piece/pattern_piece.h"
#include "ripstop/model/piece/piece_change.h"

namespace ripstop {

/// What changed from one revision to the next, pieces matched by name: those gone and changed in the order of `before`,
/// then those added. Lengths that differ by no more than `tolerance` [m] are the same (areas: by that times the
/// perimeter; the turn of the grain: by that over half the piece's size, of its arrow over half its length). Edges
/// (`compare_edges`), sew lines and drawn lines are compared where the best motion of the cut line takes them
/// (`fit_outline`); drawn lines of one name with the nearest of that name.
std::vector<PieceChange> compare_pieces(const PieceSet& before, const PieceSet& after, double tolerance);

/// The seam types of both sets, by name, that are sewn otherwise: allowance, rows, tape. One that only one set has
/// shows in the edges that name it.
std::vector<SeamTypeChange> compare_seam_types(const PieceSet& before, const PieceSet& after, double tolerance);

}  // namespace ripstop
