#pragma once

#include <vector>

#include "ripstop/nest/strip.h"

namespace ripstop {

/// Rows that are `times` as fine as those the items lie on.
struct FineRows {
    double base = 0;    ///< of all shapes, below their corner [m]
    double height = 0;  ///< [m]
    int times = 1;
};

/// Slides items that do not overlap towards the start of the roll, each as far as those before it, in the finer rows,
/// and the join before it let it. Who lies before whom does not change, nor do rows. Double precision throughout.
void slide_together(const Strip& strip, const FineRows& rows, std::vector<PlacedItem>& items);

}  // namespace ripstop
