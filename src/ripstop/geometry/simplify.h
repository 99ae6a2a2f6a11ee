#pragma once

#include "ripstop/geometry/types.h"

namespace ripstop {

/// A polyline with the points left out that the others do without: both ends are kept, and no point of the old line is
/// further than `tolerance` [m] from the new one, whose points are all of the old [DP73]. A closed line (first point
/// equal to the last) keeps its furthest point too. O(#P log #P), O(#P2) at worst.
Points2 simplified(const Points2& line, double tolerance);

}  // namespace ripstop
