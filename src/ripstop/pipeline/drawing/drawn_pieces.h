#pragma once

#include <string>
#include <vector>

#include "ripstop/model/piece/pattern_drawing.h"
#include "ripstop/model/piece/pattern_piece.h"

namespace ripstop {

/// A piece of the plan in a drawing.
struct DrawnPiece {
    const PatternPiece* piece = nullptr;
    Vec2 lower = Vec2::Zero(), upper = Vec2::Zero();  ///< bounding box of its outline in the drawing [m]
    std::vector<const DrawnPath*> outline = {};       ///< the paths that form the outline

    Vec2 shift() const { return piece->lower() - lower; }  ///< from the drawing to the piece
};

/// The pieces found in a drawing, and the names of the cut lines that match no piece.
struct DrawnPieces {
    std::vector<DrawnPiece> found = {};
    std::vector<std::string> strangers = {};
};

/// Finds the pieces in a drawing by the rules of `lift_drawing`, and throws the same errors.
DrawnPieces find_drawn_pieces(const PatternDrawing& drawing, double metres_per_unit, const PieceSet& set,
                              const std::string& stem);

}  // namespace ripstop
