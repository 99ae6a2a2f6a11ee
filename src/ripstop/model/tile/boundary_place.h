#pragma once

namespace ripstop {

/// A place on a tile's boundary: of the edge from boundary[edge] to boundary[edge + 1], this share of the way, in [0,
/// 1].
struct BoundaryPlace {
    int edge = 0;
    double share = 0;
};

}  // namespace ripstop
