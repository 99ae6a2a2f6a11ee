#pragma once

#include "ripstop/model/plan/flattening.h"
#include "ripstop/model/tile/tile.h"

namespace ripstop {

struct AonoOptions {
    double spacing = 0.5;  ///< of the threads, in mean edge lengths of the tile; > 0
    double smallest_angle =
        0.26;  ///< between threads: below it, and as near to straight, a cell is locked, in (0, 1.5) [rad]
};

/// Fitting a woven cloth of threads that do not stretch [ABW94, ABW01]: a discrete Chebyshev net.
///
///     X_ij on the surface,  |X_ij - X_i-1,j| = |X_ij - X_i,j-1| = r
///
/// Two straight lines of the surface through the middle of the tile, along the grain and across, carry equidistant
/// crossings; from there the net is swept outward, each crossing where the circles of radius r round two that are in
/// place meet, on the other side of them from the fourth of the cell. Where no cell can be closed any more, a thread
/// is led straight on. Plane coordinates are (i r, j r), read off as by `flatten_woven`. Distances are those along the
/// surface; the source measures them through space, which makes a net that is finer exact as well, but not one of
/// developable tiles.
///
/// Threads keep their length, shear takes up all: about K u v at the place (u, v) of a surface of curvature K. Where
/// threads come to lie along one another the net breaks down: such cells are left open, the summary is `stagnated` and
/// says how many crossings have no place and where the first is. What no crossing sees is laid on from its neighbours.
/// Exact on developable tiles. The result depends on the grain and on where the lines are.
///
/// Requires a disk (`make_tile`). Throws InputError for options out of range. Some 10 ms a thousand triangles.
Flattening flatten_aono(const Tile& tile, const AonoOptions& options = {});

}  // namespace ripstop
