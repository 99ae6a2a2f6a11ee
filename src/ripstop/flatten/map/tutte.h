#pragma once

#include "ripstop/model/plan/flattening.h"
#include "ripstop/model/tile/tile.h"

namespace ripstop {

/// Tutte's embedding: a flattening without flipped triangles [Tutte 1963]. The boundary lies on a circle with arcs in
/// proportion to its edge lengths, and every interior vertex is the weighted mean of its neighbours. The result is
/// scaled to the tile's own area and rotated to its grain. It is the safe start for methods that need one; its shape
/// says nothing about the tile.
///
/// The weights are symmetric and positive and the boundary is strictly convex, so no triangle can flip, whatever its
/// shape; interior edges between boundary vertices do no harm. The weights are Floater's mean value coordinates
/// [2003], made symmetric, which preserve shapes better than uniform weights. If rounding flips a triangle all the
/// same, uniform weights are tried; the summary counts what remains.
///
/// One sparse positive definite factorisation of size #interior vertices, or two.
Flattening flatten_tutte(const Tile& tile);

}  // namespace ripstop
