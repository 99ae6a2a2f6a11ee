#pragma once

#include <vector>

#include "ripstop/model/cut_plan.h"
#include "ripstop/model/pattern_piece.h"

namespace ripstop {

/// The piece of a flattened tile, in the coordinates of its flattening.
///
/// Sew line: every boundary vertex on the cloth, counter-clockwise. Label: the tile's name, and WARP below it where there is
/// room; letters as high as fit inside the sew line near the pole of inaccessibility, 3 to 40 mm, level or, on a piece too
/// narrow for that, turned upright. Where 3 mm do not fit they shrink to 1 mm, and in the last resort 1 mm letters stand at
/// the pole. Grain arrow: along +x, inside the sew line and clear of the label, at most 60 % of the width there; it
/// prefers long places near the pole. On a piece too small for both it crosses the label.
///
/// Throws InputError where the tile has no finite flat position for each boundary vertex (a failed flattening: see
/// `has_flat_positions`). Cost: some thousand looks at the outline, O(#boundary) each.
PatternPiece make_piece(const FlatTile& tile);

/// Has each vertex of the tile a finite place on the cloth? False after a failed flattening.
bool has_flat_positions(const FlatTile& tile);

/// The piece of every tile that has flat positions, in the order of the plan.
std::vector<PatternPiece> make_pieces(const CutPlan& plan);

/// Shifts that put the pieces side by side on one sheet, as they are turned, in their order, in rows from top to bottom.
/// Bounding boxes are `gap` [m] apart; the sheet is about square and its lower left corner the origin. For looking at and
/// for cutters that nest by themselves, not a marker. A piece without sew line gets no shift.
std::vector<Vec2> lay_out(const std::vector<PatternPiece>& pieces, double gap);

}  // namespace ripstop
