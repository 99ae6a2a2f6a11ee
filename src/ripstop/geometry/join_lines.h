#pragma once

#include <vector>

#include "ripstop/geometry/types.h"

namespace ripstop {

/// Lines that meet end to end, as one.
struct JoinedLine {
    Points2 points;          ///< #P x 2; the first is not repeated where it is closed
    std::vector<int> lines;  ///< those it is made of, in its order
    bool is_closed = false;  ///< its ends meet
};

/// Joins lines whose ends lie within `tolerance` of each other, whichever way round each runs, into lines as long as
/// they go. At a place where more than two ends meet, a line goes on with one that goes on itself before one that ends,
/// such as a notch drawn from an outline; of those with the nearest, of equally near ones the first. They come in the
/// order of their first lines. A line of one point or none is left as it is. O(#lines + #points) where few ends lie
/// near each other.
std::vector<JoinedLine> join_lines(const std::vector<Points2>& lines, double tolerance);

}  // namespace ripstop
