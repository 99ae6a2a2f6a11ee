#pragma once

#include <string>

#include "ripstop/base/solve_summary.h"
#include "ripstop/geometry/types.h"

namespace ripstop {

/// Where a tile's vertices lie on the cloth: +x the warp, +y the weft, the outside face up.
struct Flattening {
    Points2 positions;  ///< #V x 2 [m]
    SolveSummary summary;
    std::string note = {};  ///< what the method has to say of this tile beside the figures; may be empty
};

}  // namespace ripstop
