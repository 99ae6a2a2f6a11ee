#pragma once

#include "ripstop/mesh/adjacency.h"
#include "ripstop/model/tile/tile.h"
#include "ripstop/remesh/remesh_tile.h"

namespace ripstop {

/// The part of an area gain that the smooth surface within a new boundary explains, as estimated from the tile's
/// mesh; ratios of its area.
struct ExplainedArea {
    double boundary = 0;  ///< area between the old and the new edges, within the surface; either sign
    double bending = 0;   ///< area lost by flat triangles, from their dihedral turns and angle defects; >= 0

    /// The unexplained part of a gain of area: zero up to 1.5 times `bending`, because that is an estimate
    /// [ratio, >= 0].
    double beyond(double gain) const;
};

/// Estimates the explained area. On a grid of edges that turn by t1 and t2 the inscribed triangles lack
///
///     (t1^2 + t2^2) / 24 + t1 t2 / 6 = mean(theta^2) / 8 + mean(|D|) / 6
///
/// of their area. Here theta is the dihedral turn between triangles, weighted with the area of the two, and D = t1 t2
/// is the angle defect of an interior vertex, its Gaussian curvature. A surface without defects is developable and
/// gains by the first term only. Turns beyond 45 degrees are intended and excluded. The boundary term is measured,
/// not estimated: new edges may be longer than the old ones and then cut off more. O(#F + #nodes).
ExplainedArea explained_area(const Tile& tile, const Adjacency& adjacency, const NewBoundary& boundary);

}  // namespace ripstop
