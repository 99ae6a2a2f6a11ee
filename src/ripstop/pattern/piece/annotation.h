#pragma once

#include <string>
#include <vector>

#include "ripstop/geometry/polygon.h"
#include "ripstop/model/piece/pattern_piece.h"

namespace ripstop {

/// The place of a piece's writing: its lines, and the box around them with a small margin.
struct LabelPlace {
    std::vector<Label> labels;
    Box box;
};

/// Places `name` inside `outline`, with all lines of `notes` below it in smaller letters if there is room, else
/// with the first. Letters are at most `largest` high [m]. `room` is the largest inscribed circle. See
/// `make_pieces`.
LabelPlace place_label(const Points2& outline, const Circle& room, const std::string& name,
                       const std::vector<std::string>& notes, double largest);

/// The grain arrow (2 x 2, tail then head) along +x, inside `outline` and clear of `label`; no rows if there is no
/// room.
Points2 place_grain_line(const Points2& outline, const Circle& room, const Box& label);

}  // namespace ripstop
