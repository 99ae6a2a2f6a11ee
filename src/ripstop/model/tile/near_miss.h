#pragma once

#include "ripstop/geometry/types.h"

namespace ripstop {

/// Two boundary runs that lie next to each other but form no seam: too far apart, or in the same direction.
struct NearMiss {
    int tile_a = 0, chain_a = 0;  ///< indices in `Envelope::tiles` and `Tile::chains`
    int tile_b = 0, chain_b = 0;
    double length = 0;          ///< length of the run [m]
    double distance = 0;        ///< largest distance between the two [m]
    Vec3 place = Vec3::Zero();  ///< place of the largest distance [m]
    double overlap = 0;         ///< how far b lies inside a's edge there, measured across the edge; negative: a gap [m]
};

}  // namespace ripstop
