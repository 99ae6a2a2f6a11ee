#pragma once

#include <vector>

#include "ripstop/geometry/types.h"

namespace ripstop {

/// A tile that is another one turned about the axis.
struct TurnedTile {
    int of = 0;                    ///< the tile in the first sector
    int turns = 0;                 ///< by how many sectors
    std::vector<int> vertex = {};  ///< of that tile, the place of each of this one's vertices; empty: the same numbers
};

/// An envelope whose pieces repeat in equal sectors about a vertical axis.
struct Symmetry {
    int sectors = 1;
    Vec3 axis = Vec3::Zero();       ///< a point of it [m]
    std::vector<TurnedTile> tiles;  ///< of each tile of the plan

    double angle() const { return 2 * 3.14159265358979323846 / sectors; }
};

}  // namespace ripstop
