#pragma once

#include <vector>

#include "ripstop/nest/roll_strip.h"

namespace ripstop {

/// A grid of rows `times` as fine as the rows the items lie on.
struct FineRows {
    double base = 0;    ///< of all shapes, below their lower left corner [m]
    double height = 0;  ///< [m]
    int times = 1;
};

/// Slides items that do not overlap towards the start of the roll, one after the other, as far as the items before
/// it (compared in the finer rows) and the join before it allow. Neither the order of the items along the roll nor
/// their rows change. All in double precision.
void slide_together(const Strip& strip, const FineRows& rows, std::vector<PlacedItem>& items);

}  // namespace ripstop
