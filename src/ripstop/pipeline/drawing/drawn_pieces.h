#pragma once

#include <string>
#include <vector>

#include "ripstop/model/piece/pattern_drawing.h"
#include "ripstop/model/piece/pattern_piece.h"

namespace ripstop {

/// A piece of the plan in a drawing.
struct DrawnPiece {
    const PatternPiece* piece = nullptr;
    Vec2 lower = Vec2::Zero(), upper = Vec2::Zero();  ///< of its outline in the drawing [m]
    std::vector<const DrawnPath*> outline = {};       ///< what it is made of

    Vec2 shift() const { return piece->lower() - lower; }  ///< from the drawing to the piece
};

/// The pieces in a drawing, and what its other cut lines are called.
struct DrawnPieces {
    std::vector<DrawnPiece> found = {};
    std::vector<std::string> strangers = {};
};

/// As `lift_drawing` tells, and throws.
DrawnPieces find_drawn_pieces(const PatternDrawing& drawing, double metres_per_unit, const PieceSet& set,
                              const std::string& stem);

}  // namespace ripstop
