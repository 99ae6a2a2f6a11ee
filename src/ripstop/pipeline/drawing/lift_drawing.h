#pragma once

#include <functional>
#include <string>
#include <vector>

#include "ripstop/model/piece/pattern_drawing.h"
#include "ripstop/model/piece/pattern_piece.h"
#include "ripstop/model/tile/cad_model.h"

namespace ripstop {

/// What was drawn on flat pieces, on the tiles in space [m].
struct LiftedLines {
    std::vector<NamedCurve> curves =
        {};          ///< named `LAYER PIECE`, attribute `layer` as in the drawing, `tile` the piece's name
    int pieces = 0;  ///< found in the drawing
    std::vector<std::string> strangers =
        {};  ///< cut lines of the drawing that are no piece's, as they are called there
};

/// Carries the lines of a drawing back to the tiles: artwork drawn on the patterns, for the model they came from.
///
/// A piece is found by its cut line, or its sew line where it is not cut: a closed line of the drawing, also in parts
/// that meet, whose points lie within 0.1 mm of it wherever it was moved to, not turned and not mirrored. Of equal
/// pieces it is the one whose name the drawing has: the SVG group or DXF block it is in, else the text where the piece
/// has its name, else the largest text inside. A cut line with the name of a piece that has another shape is a
/// stranger. Where no name is there it is the only piece of this shape, or of several the one whose files are called
/// `stem`.
///
/// What the piece itself brings (sew line, grain arrow, match marks) is no line; of all others the part within the sew
/// line is lifted (`lift_line`), cut in pieces where it leaves it. `metres_per_unit` scales the drawing. `tile(piece)`
/// gives the tile with its flat positions (`NamedMesh::drawn`); it is asked only for pieces that are found. Throws
/// InputError where several pieces fit and nothing tells which. O(lines x #F) a piece.
LiftedLines lift_drawing(const PatternDrawing& drawing, double metres_per_unit, const PieceSet& set,
                         const std::function<NamedMesh(const PatternPiece&)>& tile, const std::string& stem = "");

}  // namespace ripstop
