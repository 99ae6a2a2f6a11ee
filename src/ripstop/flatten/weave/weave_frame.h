#pragma once

#include "ripstop/mesh/geodesic.h"
#include "ripstop/model/tile/tile.h"

namespace ripstop {

/// The origin, direction and spacing of a weave on a tile.
struct WeaveFrame {
    SurfacePoint centre;        ///< a crossing of the weave
    Vec2 warp = Vec2::UnitX();  ///< unit direction of the warp there, in the frame of the centre's triangle
    double spacing = 0;         ///< yarn spacing [m]
};

/// The frame of a weave through the point of the tile nearest its area centroid, or further inside if that is close
/// to the boundary. The warp is the mean grain over the visible surroundings. `relative_spacing` is in mean edge
/// lengths; it is adjusted if it gave fewer than three yarns across a narrow tile, fewer than about 100 crossings, or
/// more than 20 per triangle.
WeaveFrame make_weave_frame(const Tile& tile, const Adjacency& adjacency, const UnfoldedSurface& surface,
                            double relative_spacing);

/// The largest number of crossings placed on a tile.
int most_crossings(const Tile& tile);

}  // namespace ripstop
