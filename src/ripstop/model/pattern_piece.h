#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "ripstop/geometry/types.h"

namespace ripstop {

/// A text on a piece: where its middle is, how high the letters are, turned by how much from +x.
struct Label {
    std::string text;
    Vec2 middle = Vec2::Zero();
    double height = 0.02;  ///< [m]
    double turn = 0;       ///< [rad], counter-clockwise
};

/// What is drawn for the cutter: the flat piece in metres, +x the warp, outside face up.
struct PatternPiece {
    std::string name;
    Points2 sew_line;    ///< closed, counter-clockwise, the first point not repeated
    Points2 grain_line;  ///< 2 x 2: tail and head of the grain arrow, inside the piece
    std::vector<Label> labels;

    Vec2 lower() const { return sew_line.colwise().minCoeff(); }
    Vec2 upper() const { return sew_line.colwise().maxCoeff(); }
};

/// Length along the shaft of the arrow head of a grain line `length` long, and half its width [m].
inline double arrow_head(double length) {
    return std::min(0.012, 0.2 * length);
}
inline double arrow_half_width(double length) {
    return 0.3 * arrow_head(length);
}

}  // namespace ripstop
