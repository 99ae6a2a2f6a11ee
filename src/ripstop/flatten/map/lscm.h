#pragma once

#include "ripstop/model/plan/flattening.h"
#include "ripstop/model/tile/tile.h"

namespace ripstop {

/// Least-squares conformal map [Levy, Petitjean, Ray, Maillot 2002], scaled to the tile's own area and turned to its
/// grain.
///
/// Minimises Σ_t A_t |∇v - R ∇u|², R the quarter turn and (u, v) the flat coordinates, with the two boundary vertices
/// that lie farthest apart in space held. Keeps angles, not lengths: a start for the true methods and a baseline. Exact
/// on developable tiles, to about 1e-9 in length; digits are lost on tiles hundreds of times longer than wide. Nothing
/// keeps it from turning triangles over on strongly curved ones; their number is in the summary.
///
/// One sparse positive definite solve of size 2 #V - 4, and #B² / 2 distances for #B boundary vertices.
Flattening flatten_lscm(const Tile& tile);

}  // namespace ripstop
