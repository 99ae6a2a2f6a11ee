#pragma once

#include <vector>

#include "ripstop/model/piece/pattern_piece.h"

namespace ripstop {

/// What a drawing of pieces covers, the reference square included, in metres.
struct Sheet {
    static constexpr double square_side =
        0.1;  ///< drawn so that whoever opens the file can measure that it is true to size
    Vec2 lower = Vec2::Zero(), upper = Vec2::Zero();
    Vec2 square = Vec2::Zero();  ///< lower left corner of the reference square, right of the pieces
    std::vector<Vec2> shifts;    ///< one a piece
};

/// `shifts` empty: the pieces stay where they are. Throws InputError where there are neither none nor as many as
/// pieces.
Sheet make_sheet(const std::vector<PatternPiece>& pieces, const std::vector<Vec2>& shifts);

/// The grain arrow as strokes (4 x 2 or no row): tail, head, and the ends of the two barbs that meet at the head.
Points2 grain_arrow(const PatternPiece& piece);

}  // namespace ripstop
