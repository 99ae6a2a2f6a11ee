#pragma once

#include "ripstop/model/plan/flattening.h"
#include "ripstop/model/tile/tile.h"

namespace ripstop {

/// Least-squares conformal map [Levy, Petitjean, Ray, Maillot 2002], scaled to the tile's own area and rotated to its
/// grain.
///
/// Minimises Σ_t A_t |∇v - R ∇u|², where R is the quarter turn and (u, v) are the flat coordinates. The two boundary
/// vertices farthest apart in space are fixed. It keeps angles, not lengths: a start for other methods and a
/// baseline. Exact on developable tiles to about 1e-9 in length; it loses digits on tiles hundreds of times longer
/// than wide. It does not prevent flipped triangles on strongly curved tiles; the summary counts them.
///
/// One sparse positive definite solve of size 2 #V - 4, and #B² / 2 distances for #B boundary vertices.
Flattening flatten_lscm(const Tile& tile);

}  // namespace ripstop
