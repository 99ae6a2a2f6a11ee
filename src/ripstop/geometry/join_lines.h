#pragma once

#include <vector>

#include "ripstop/geometry/types.h"

namespace ripstop {

/// A chain of lines that meet end to end.
struct JoinedLine {
    Points2 points;          ///< #P x 2; a closed line does not repeat its first point
    std::vector<int> lines;  ///< the input lines it consists of, in order
    bool is_closed = false;  ///< its ends meet
};

/// Joins lines whose ends lie within `tolerance` of each other into chains as long as possible; lines may run either
/// way round. Where more than two ends meet, a line continues with one that continues itself rather than one that
/// ends there, such as a notch drawn from an outline; among those it takes the nearest, then the first. The results
/// are ordered by their first lines. A line of at most one point is returned unchanged. O(#lines + #points) where few
/// ends are close.
std::vector<JoinedLine> join_lines(const std::vector<Points2>& lines, double tolerance);

}  // namespace ripstop
