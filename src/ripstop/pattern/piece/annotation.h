#pragma once

#include <string>
#include <vector>

#include "ripstop/geometry/polygon.h"
#include "ripstop/model/piece/pattern_piece.h"

namespace ripstop {

/// Where the writing of a piece goes: its lines and the box around them with a little air.
struct LabelPlace {
    std::vector<Label> labels;
    Box box;
};

/// Places `name` inside `outline`, with the lines of `notes` below it in smaller letters where there is room for all of
/// them, else with the first; letters no higher than `largest` [m]. `room` is the largest circle inside. See
/// `make_pieces`.
LabelPlace place_label(const Points2& outline, const Circle& room, const std::string& name,
                       const std::vector<std::string>& notes, double largest);

/// The grain arrow (2 x 2, tail then head) along +x inside `outline`, clear of `label`; zero rows where there is no
/// room.
Points2 place_grain_line(const Points2& outline, const Circle& room, const Box& label);

}  // namespace ripstop
