#pragma once

#include "ripstop/model/tile/seam_type.h"

namespace ripstop {

/// A seam type and how much of it is sewn.
struct SeamTypeUse {
    SeamType type;
    int seams = 0, free_edges = 0;  ///< free edges: chains that are not entirely in seams
    double length = 0;              ///< total length [m]
};

}  // namespace ripstop
