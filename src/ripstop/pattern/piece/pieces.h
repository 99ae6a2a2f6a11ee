#pragma once

#include <string>
#include <vector>

#include "ripstop/base/text/units.h"
#include "ripstop/model/piece/pattern_piece.h"
#include "ripstop/model/plan/cut_plan.h"
#include "ripstop/pattern/cut/cut_line.h"
#include "ripstop/pattern/piece/notches.h"

namespace ripstop {

/// How `make_pieces` draws sew lines, corners and notches.
struct PieceOptions {
    double chord_error = 0.05 * millimetre;  ///< by which the sew line may leave out vertices
    CornerRule corners = CornerRule::mitre;  ///< between two sewn edges; hems are folded
    NotchOptions notches = {};
    std::string revision = {};  ///< written on every piece
};

/// What the tile says of its colour: the attribute `colour`, `color` or `material`; empty: nothing.
std::string colour_of(const Tile& tile);

/// Has each vertex of the tile a finite place on the cloth? False after a failed flattening.
bool has_flat_positions(const FlatTile& tile);

/// The piece of every tile that has flat positions, in the order of the plan and the coordinates of its flattening.
///
/// Sew line and edges: `make_outlines`. Cut line: the sew line and the allowances of its seams and hems
/// (`make_cut_line`). Notches: `make_notches`. Label: the tile's name, and below it, where there is room, WARP, how
/// many are cut of it, gore and row, and the revision; letters as high as fit inside the sew line near the pole of
/// inaccessibility, 3 to 40 mm, level or, on a piece too narrow for that, turned upright. Where 3 mm do not fit they
/// shrink to 1 mm, and in the last resort 1 mm letters stand at the pole. Grain arrow: along +x, inside the sew line
/// and clear of the label, at most 60 % of the width there; it prefers long places near the pole. On a piece too small
/// for both it crosses the label. Names of the neighbours stand along the edges (`place_edge_labels`). Gore and row are
/// the attributes `gore` and `row` or `panel` of the tile, else read off a name such as G03P07.
///
/// Cost: some thousand looks at each outline, O(#boundary) each, on `threads` threads (0: one a core).
std::vector<PatternPiece> make_pieces(const CutPlan& plan, const PieceOptions& options = {}, int threads = 0);

}  // namespace ripstop
