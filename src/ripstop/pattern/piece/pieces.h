#pragma once

#include <string>
#include <vector>

#include "ripstop/base/text/units.h"
#include "ripstop/model/piece/pattern_piece.h"
#include "ripstop/model/plan/cut_plan.h"
#include "ripstop/pattern/cut/cut_line.h"
#include "ripstop/pattern/piece/notches.h"

namespace ripstop {

/// Options for sew lines, corners and notches.
struct PieceOptions {
    double chord_error = 0.05 * millimetre;  ///< largest distance of the sew line from the vertices it leaves out [m]
    CornerRule corners = CornerRule::mitre;  ///< between two sewn edges; hems are folded
    NotchOptions notches = {};
    std::string revision = {};  ///< written on every piece
};

/// The colour of a tile: its attribute `colour`, `color` or `material`; empty if it has none.
std::string colour_of(const Tile& tile);

/// The piece of every tile that has flat positions, in the order of the plan and in the coordinates of its
/// flattening.
///
/// Sew line and edges come from `make_outlines`, the cut line from the allowances of its seams and hems
/// (`make_cut_line`), notches from `make_notches`. Gore and row are the attributes `gore` and `row` or `panel` of
/// the tile, else they are read from a name such as G03P07.
///
/// The label is the tile's name and, if there is room, below it WARP, how many are cut, gore and row, and the
/// revision. Letters are as high as fit inside the sew line near the pole of inaccessibility, 3 to 40 mm; they are
/// level, or turned upright on a piece too narrow for that. If 3 mm do not fit, they shrink to 1 mm; as a last
/// resort, 1 mm letters stand at the pole.
///
/// The grain arrow points along +x, inside the sew line and clear of the label, at most 60 % of the width there.
/// It prefers long places near the pole. On a piece too small for both, it crosses the label. The neighbours'
/// names stand along the edges (`place_edge_labels`).
///
/// Cost: some thousand queries of each outline, O(#boundary) each, on `threads` threads (0: one per core).
std::vector<PatternPiece> make_pieces(const CutPlan& plan, const PieceOptions& options = {}, int threads = 0);

}  // namespace ripstop
