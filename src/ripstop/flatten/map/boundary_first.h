#pragma once

#include "ripstop/model/plan/flattening.h"
#include "ripstop/model/tile/tile.h"

namespace ripstop {

/// Boundary first flattening with an isometric boundary [SC17]: the conformal map whose scale is one along the cut
/// line.
///
/// With A the cotangent matrix, Omega the angle defects inside and k the turning of the boundary on the surface,
///
///     A_II a = -Omega        a: the logarithm of the scale inside, zero on the boundary
///     k' = k + A_BI a        how much the cut line turns on the cloth
///
/// the cut line is laid edge by edge with the drawn lengths and the turning k', the small gap that is left at its end
/// is spread over the lengths, and the inside follows harmonically. Edges are within that gap of their lengths, angles
/// are true where the scale varies slowly; area is what gives. Exact on developable tiles.
///
/// Requires a disk (`make_tile`). One factorisation of size #V - #B and three solves: the cheapest method of all.
/// Triangles that are turned over are counted in the summary's reason.
Flattening flatten_boundary_first(const Tile& tile);

}  // namespace ripstop
