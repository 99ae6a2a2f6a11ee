#pragma once

#include "ripstop/base/solve_summary.h"
#include "ripstop/geometry/types.h"

namespace ripstop {

/// Where a tile's vertices lie on the cloth: +x the warp, +y the weft, the outside face up.
struct Flattening {
    Points2 positions;  ///< #V x 2 [m]
    SolveSummary summary;
};

}  // namespace ripstop
