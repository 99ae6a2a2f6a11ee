#pragma once

#include "ripstop/mesh/adjacency.h"
#include "ripstop/model/tile/tile.h"
#include "ripstop/remesh/remesh_tile.h"

namespace ripstop {

/// By how much the smooth surface within a tile's new boundary has more area than the tile's mesh, as far as the mesh
/// itself tells; ratios.
struct ExplainedArea {
    double boundary = 0;  ///< between the old edges and the new ones, in the surface; of either sign
    double bending = 0;   ///< of the triangles, from their turns and the angles that lack about the vertices; >= 0

    /// What a gain of area is beyond it: nothing up to half as much again, for the second is an estimate [ratio, >= 0].
    double beyond(double gain) const;
};

/// On a grid of edges that turn by t1 and t2 the inscribed triangles lack
///
///     (t1^2 + t2^2) / 24 + t1 t2 / 6 = mean(theta^2) / 8 + mean(|D|) / 6
///
/// of their area, theta the turn from triangle to triangle, weighted with the area of the two, D the angle that is
/// missing about an interior vertex: t1 t2, the Gaussian curvature. Where none is missing the surface is developable,
/// and gains from its first term only. Turns beyond 45 degrees are meant and left out. The boundary's part is measured,
/// not estimated: the new edges may be longer than the old ones, and then cut off more. O(#F + #nodes).
ExplainedArea explained_area(const Tile& tile, const Adjacency& adjacency, const NewBoundary& boundary);

}  // namespace ripstop
