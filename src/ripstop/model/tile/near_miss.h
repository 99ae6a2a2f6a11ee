#pragma once

#include "ripstop/geometry/types.h"

namespace ripstop {

/// Two runs of boundary that lie beside each other and yet are no seam: too far apart, or running the same way.
struct NearMiss {
    int tile_a = 0, chain_a = 0;  ///< in `Envelope::tiles`, `Tile::chains`
    int tile_b = 0, chain_b = 0;
    double length = 0;          ///< of the run [m]
    double distance = 0;        ///< largest distance between the two [m]
    Vec3 place = Vec3::Zero();  ///< where that is [m]
    double overlap = 0;         ///< there b lies this far inside a's edge, across it; negative: beyond it, a gap [m]
};

}  // namespace ripstop
