#pragma once

#include <vector>

#include "ripstop/geometry/types.h"

namespace ripstop {

/// A tile that is a rotated copy of another one about the axis.
struct TurnedTile {
    int of = 0;                    ///< the tile of the first sector
    int turns = 0;                 ///< number of sectors of the rotation
    std::vector<int> vertex = {};  ///< vertex of that tile for each of this tile's vertices; empty: the same numbers
};

/// An envelope whose pieces repeat in equal sectors about a vertical axis.
struct Symmetry {
    int sectors = 1;
    Vec3 axis = Vec3::Zero();       ///< a point on the axis [m]
    std::vector<TurnedTile> tiles;  ///< one per tile of the plan

    double angle() const { return 2 * 3.14159265358979323846 / sectors; }
};

}  // namespace ripstop
