#pragma once

#include "ripstop/model/plan/flattening.h"
#include "ripstop/model/tile/tile.h"

namespace ripstop {

/// A flattening without a single flipped triangle: the boundary on a circle, its edges as arcs in proportion to their
/// lengths, and every inner vertex in the weighted mean of its neighbours [Tutte 1963], scaled to the tile's own area
/// and turned to its grain. A safe start where nothing else is; its shape says nothing about the tile.
///
/// Because the weights are symmetric and positive and the boundary is strictly convex, no triangle can flip, whatever
/// the triangles' shape; inner edges between boundary vertices do no harm. The weights are Floater's mean values [2003]
/// made symmetric, which keeps triangles' shapes better than equal ones. Where rounding flips a triangle all the same,
/// equal weights are tried; what is left is counted in the summary.
///
/// One sparse positive definite factorisation of size #inner vertices, or two.
Flattening flatten_tutte(const Tile& tile);

}  // namespace ripstop
