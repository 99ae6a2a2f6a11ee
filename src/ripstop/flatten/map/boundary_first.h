#pragma once

#include "ripstop/model/plan/flattening.h"
#include "ripstop/model/tile/tile.h"

namespace ripstop {

/// Boundary first flattening with an isometric boundary [SC17]: the conformal map whose scale factor is one along the
/// cut line.
///
/// Let A be the cotangent matrix, Omega the interior angle defects and k the turning of the boundary on the surface:
///
///     A_II a = -Omega        a: the logarithm of the scale inside, zero on the boundary
///     k' = k + A_BI a        the turning of the cut line on the cloth
///
/// The cut line is laid edge by edge with the drawn lengths and the turning k'. The small gap at its end is
/// distributed over the lengths, and the interior follows harmonically. Edge lengths are exact up to that gap, and
/// angles are accurate where the scale varies slowly; the error is in the area. Exact on developable tiles.
///
/// Requires a disk (`make_tile`). One factorisation of size #V - #B and three solves: the cheapest of all methods.
/// The reason in the summary counts flipped triangles.
Flattening flatten_boundary_first(const Tile& tile);

}  // namespace ripstop
