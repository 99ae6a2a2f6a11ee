#pragma once

#include <vector>

#include "ripstop/assembly/seams/find_seams.h"
#include "ripstop/remesh/remesh_tile.h"

namespace ripstop {

struct NewBoundaries {
    std::vector<NewBoundary> tiles;  ///< per tile; without nodes if the tile is unchanged
    std::vector<Seam> seams;         ///< the same seams on the new boundaries
};

/// Divides the boundaries of the tiles to be remeshed into edges of about `edge_lengths` [m] (per tile; 0: unchanged).
/// `length_tolerance` is a ratio.
///
/// Every seam is divided once for both sides. They get the same vertices, on the curve with which the seam was measured
/// (`find_seams`), at the shorter of the two edge lengths and at most 4 degrees of turn per edge. If one side is
/// unchanged, the other takes its vertices, provided that they are not too dense (a quarter of the edge length) or too
/// far apart after others are inserted. Suitable vertices are kept. Corners stay in place, each side's own. Where a
/// seam ends within a chain (a T-junction), the chain gets a vertex at that corner.
///
/// Lengths are those of the found seams, distributed by arc length, with one exception: a seam or loose edge known only
/// as a polyline that turns too much for the tolerance (t^2 / 24 beyond half of it) takes the length of its smooth
/// curve. This holds for all edges of a tile or for none: if such seams join tiles and one of them is unchanged, they
/// all keep their polylines.
NewBoundaries divide_boundaries(const std::vector<Tile>& tiles, const FoundSeams& found,
                                const std::vector<double>& edge_lengths, double length_tolerance,
                                double seam_tolerance);

/// For each seam: both sides share their vertices, and the polyline turns too much for the tolerance.
std::vector<bool> find_coarse_seams(const std::vector<Tile>& tiles, const FoundSeams& found, double length_tolerance);

}  // namespace ripstop
