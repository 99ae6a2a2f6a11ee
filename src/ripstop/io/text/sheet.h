#pragma once

#include <vector>

#include "ripstop/model/piece/pattern_piece.h"

namespace ripstop {

/// The area that a drawing of pieces covers, the reference square included, in metres.
struct Sheet {
    static constexpr double square_side =
        0.1;  ///< side of a square that is drawn so that users can check the scale of the file
    Vec2 lower = Vec2::Zero(), upper = Vec2::Zero();
    Vec2 square = Vec2::Zero();  ///< lower left corner of the reference square, right of the pieces
    std::vector<Vec2> shifts;    ///< one for each piece
};

/// Arranges the pieces; without `shifts` they stay in place. Throws InputError unless there are no shifts or one
/// for each piece.
Sheet make_sheet(const std::vector<PatternPiece>& pieces, const std::vector<Vec2>& shifts);

/// The grain arrow as strokes (4 x 2, or no rows): tail, head, and the ends of the two barbs that meet at the
/// head.
Points2 grain_arrow(const PatternPiece& piece);

}  // namespace ripstop
