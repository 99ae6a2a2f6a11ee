#pragma once

#include "ripstop/model/plan/flattening.h"
#include "ripstop/model/tile/tile.h"

namespace ripstop {

struct AonoOptions {
    double spacing = 0.5;  ///< thread spacing, in mean edge lengths of the tile; > 0
    double smallest_angle =
        0.26;  ///< least angle between threads: a cell is locked below it, or within it of pi, in (0, 1.5) [rad]
};

/// Fits a woven cloth of inextensible threads [ABW94, ABW01]: a discrete Chebyshev net.
///
///     X_ij on the surface,  |X_ij - X_i-1,j| = |X_ij - X_i,j-1| = r
///
/// Two straight lines on the surface through the middle of the tile, along the grain and across, carry equidistant
/// crossings. From there the net grows outward: each new crossing is the intersection of the circles of radius r
/// round two placed ones, opposite the fourth crossing of the cell. Where no cell can be closed, a thread is extended
/// straight on. The plane coordinates are (i r, j r), read off as in `flatten_woven`. Distances are measured along
/// the surface. The source measures them through space: its net converges as the spacing is refined, but is not exact
/// on developable tiles.
///
/// Threads keep their length and shear absorbs all deformation: about K u v at the place (u, v) of a surface of
/// curvature K. The net breaks down where threads coincide. Such cells stay open; the summary is `stagnated` and
/// reports the number of crossings without a place, and the first of them. Vertices that no crossing sees are laid on
/// from their neighbours. Exact on developable tiles. The result depends on the grain and on the two lines.
///
/// Requires a disk (`make_tile`). Throws InputError if the options are out of range. About 10 ms per thousand
/// triangles.
Flattening flatten_aono(const Tile& tile, const AonoOptions& options = {});

}  // namespace ripstop
