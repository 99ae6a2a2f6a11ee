#pragma once

#include "ripstop/mesh/geodesic.h"
#include "ripstop/model/tile/tile.h"

namespace ripstop {

/// Where a weave begins on a tile.
struct WeaveFrame {
    SurfacePoint centre;        ///< of the weave: a crossing
    Vec2 warp = Vec2::UnitX();  ///< its direction there, unit length, in the frame of the centre's triangle
    double spacing = 0;         ///< of the yarns [m]
};

/// The weave through the point of the tile nearest its area centre, or further in where that is close to the boundary,
/// warp along the grain: its mean over what is seen from there. `relative_spacing` is in mean edge lengths, changed
/// where that were fewer than three yarns across a narrow tile, fewer than some 100 crossings, or more than 20 a
/// triangle.
WeaveFrame make_weave_frame(const Tile& tile, const Adjacency& adjacency, const UnfoldedSurface& surface,
                            double relative_spacing);

/// No more crossings than this are placed on a tile.
int most_crossings(const Tile& tile);

}  // namespace ripstop
