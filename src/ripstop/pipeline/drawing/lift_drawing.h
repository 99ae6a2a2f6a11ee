#pragma once

#include <functional>
#include <string>
#include <vector>

#include "ripstop/model/piece/pattern_drawing.h"
#include "ripstop/model/piece/pattern_piece.h"
#include "ripstop/model/tile/cad_model.h"

namespace ripstop {

/// Lines drawn on flat pieces, lifted onto the tiles in space [m].
struct LiftedLines {
    std::vector<NamedCurve> curves =
        {};          ///< named `LAYER PIECE`, attribute `layer` as in the drawing, `tile` the piece's name
    int pieces = 0;  ///< number of pieces found in the drawing
    std::vector<std::string> strangers = {};  ///< names of cut lines in the drawing that match no piece
};

/// Carries the lines of a drawing back to the tiles: artwork drawn on the patterns returns to the model.
///
/// A piece is found by its cut line, or by its sew line if it has no cut line. This is a closed line, perhaps in
/// several parts that meet, whose points lie within 0.1 mm of the piece's outline after a translation. Rotated and
/// mirrored pieces are not found. Equal pieces are told apart by the name in the drawing: the SVG group or DXF block of
/// the line, else the text at the place of the piece's name, else the largest text inside. A cut line that bears the
/// name of a piece of another shape matches no piece. Without a name, the line is the only piece of this shape; if
/// there are several, it is the one whose file name is `stem`.
///
/// The piece's own lines (sew line, grain arrow, match marks) are skipped. Of every other line, the part inside the sew
/// line is lifted (`lift_line`) and is split where it leaves the piece. `metres_per_unit` scales the drawing.
/// `tile(piece)` returns the tile with its flat positions (`NamedMesh::drawn`); it is called only for pieces that are
/// found. Throws InputError if several pieces fit and nothing tells which. O(lines x #F) per piece.
LiftedLines lift_drawing(const PatternDrawing& drawing, double metres_per_unit, const PieceSet& set,
                         const std::function<NamedMesh(const PatternPiece&)>& tile, const std::string& stem = "");

}  // namespace ripstop
