#pragma once

#include "ripstop/model/plan/bounds.h"
#include "ripstop/model/plan/verdict.h"
#include "ripstop/model/tile/tile.h"

namespace ripstop {

/// Computes the bounds of a tile. The disc is centred at the deepest point of the tile and is the largest into which
/// 360 straight lines from there fit; its edge is the polygon of straight lines on the surface between their ends. If
/// those do not see each other or the lines have crossed (a fold or a sharp point in the disc), the ratio is 1. The
/// tile's compensation is taken into account. O(#F log #F).
Bounds measure_bounds(const Tile& tile);

/// The largest ratio of principal stretches that the tolerances for strain e and shear g permit: (1 + e) / (1 - e)
/// sqrt((1 + sin g) / (1 - sin g)).
double allowed_stretch_ratio(const Tolerances& tolerances);

}  // namespace ripstop
