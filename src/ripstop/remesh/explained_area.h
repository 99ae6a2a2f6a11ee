#pragma once

#include "ripstop/model/tile.h"
#include "ripstop/remesh/smooth_surface.h"

namespace ripstop {

/// By how much the smooth surface that a mesh stands for has more area than the mesh, as far as the mesh itself tells; ratios.
struct ExplainedArea {
    double boundary = 0;  ///< between the edges and the boundary's curves, in the surface; of either sign
    double bending = 0;   ///< of the triangles, from their turns and the angles that lack about the vertices; >= 0

    /// What a gain of area is beyond it: nothing up to half as much again, for the second is an estimate [ratio, >= 0].
    double beyond(double gain) const;
};

/// On a grid of edges that turn by t1 and t2 the inscribed triangles lack
///
///     (t1^2 + t2^2) / 24 + t1 t2 / 6 = mean(theta^2) / 8 + mean(|D|) / 6
///
/// of their area, theta the turn from triangle to triangle, weighted with the area of the two, D the angle that is missing
/// about an interior vertex: t1 t2, the Gaussian curvature. Where none is missing the surface is developable, and gains from
/// its first term only. Turns beyond 45 degrees are meant and left out. A curve with end slopes m0 and m1 over an edge d lies
/// |d| (m0 - m1) . o / 12 outside it, o the outward direction in the surface. O(#F).
ExplainedArea explained_area(const Tile& tile, const Adjacency& adjacency, const BoundarySlopes& slopes);

}  // namespace ripstop
