#pragma once

#include <vector>

#include "ripstop/assembly/seams/find_seams.h"
#include "ripstop/remesh/remesh_tile.h"

namespace ripstop {

struct NewBoundaries {
    std::vector<NewBoundary> tiles;  ///< of each tile; without nodes where it stays as it is
    std::vector<Seam> seams;         ///< the same seams over the new boundaries
};

/// Divides the boundaries of the tiles that are to be remeshed into edges of about `edge_lengths` [m] (of each tile; 0:
/// it stays as it is). `length_tolerance` is a ratio.
///
/// Every seam is divided once, for both sides: they get the same vertices, on the curve the seam was measured on
/// (`find_seams`), at the shorter of the two edge lengths and at most 4 degrees of turn an edge. Where one side stays
/// as it is the other takes its vertices, if they are neither too dense (a quarter of the edge length) nor, then with
/// others between them, too far apart. Vertices that serve are kept. Corners stay where they are, each side's own;
/// where a seam ends within a chain (a T-junction) the chain gets a vertex at the corner there.
///
/// Lengths are those of the seams as found, shared by arc length, with one exception: a seam or loose edge known only
/// as a polyline that turns too much for the tolerance (t^2 / 24 beyond half of it) takes the length of its smooth
/// curve. It does so on all edges of a tile or on none: where one tile of those that such seams join stays as it is,
/// they all keep their polylines.
NewBoundaries divide_boundaries(const std::vector<Tile>& tiles, const FoundSeams& found,
                                const std::vector<double>& edge_lengths, double length_tolerance,
                                double seam_tolerance);

/// Of each seam: both sides share their vertices, and the polyline turns too much for the tolerance.
std::vector<bool> find_coarse_seams(const std::vector<Tile>& tiles, const FoundSeams& found, double length_tolerance);

}  // namespace ripstop
