#pragma once

namespace ripstop {

/// A place on a tile's boundary: on the edge from boundary[edge] to boundary[edge + 1], at this fraction in [0, 1].
struct BoundaryPlace {
    int edge = 0;
    double share = 0;
};

}  // namespace ripstop
