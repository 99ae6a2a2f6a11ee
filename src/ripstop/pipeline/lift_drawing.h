#pragma once

#include <functional>
#include <string>
#include <vector>

#include "ripstop/model/cad_model.h"
#include "ripstop/model/pattern_drawing.h"
#include "ripstop/model/pattern_piece.h"

namespace ripstop {

/// What was drawn on flat pieces, on the tiles in space [m].
struct LiftedLines {
    std::vector<NamedCurve> curves =
        {};          ///< named `LAYER PIECE`, attribute `layer` as in the drawing, `tile` the piece's name
    int pieces = 0;  ///< found in the drawing
};

/// Carries the lines of a drawing back to the tiles: artwork drawn on the patterns, for the model they came from.
///
/// A piece is found by its cut line, or its sew line where it is not cut, as a closed path of the drawing: the same size and
/// area wherever it was moved to, not turned. Of equal pieces the first free one is taken, in the order of the drawing.
/// What the piece itself brings (sew line, grain arrow) is no line; of all others the part within the sew line is lifted
/// (`lift_line`), cut in pieces where it leaves it. `metres_per_unit` scales the drawing. `tile(name)` gives the tile with
/// its flat positions (`NamedMesh::drawn`); it is asked only for pieces that are found. O(lines x #F) a piece.
LiftedLines lift_drawing(const PatternDrawing& drawing, double metres_per_unit, const PieceSet& set,
                         const std::function<NamedMesh(const PatternPiece&)>& tile);

}  // namespace ripstop
