#pragma once

#include <string>
#include <vector>

#include "ripstop/geometry/polygon.h"
#include "ripstop/model/pattern_piece.h"

namespace ripstop {

/// Where the writing of a piece goes: its lines and the box around them with a little air.
struct LabelPlace {
    std::vector<Label> labels;
    Box box;
};

/// Places `name`, with a line `WARP` where there is room, inside `outline`; letters no higher than `largest` [m]. `room` is
/// the largest circle inside. See `make_piece`.
LabelPlace place_label(const Points2& outline, const Circle& room, const std::string& name, double largest);

/// The grain arrow (2 x 2, tail then head) along +x inside `outline`, clear of `label`; zero rows where there is no room.
Points2 place_grain_line(const Points2& outline, const Circle& room, const Box& label);

}  // namespace ripstop
