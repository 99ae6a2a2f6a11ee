#pragma once

#include "ripstop/model/plan/bounds.h"
#include "ripstop/model/plan/verdict.h"
#include "ripstop/model/tile/tile.h"

namespace ripstop {

/// The disc is centred where the tile is deepest, and as large as 360 straight lines from there fit into it; its edge
/// is the polygon of straight lines on the surface between their ends. Where these do not see each other, or the lines
/// have crossed (a fold or a sharp point in the disc), nothing is claimed: ratio 1. Against what the cloth is to be:
/// the tile's compensation counts. O(#F log #F).
Bounds measure_bounds(const Tile& tile);

/// The largest ratio of principal stretches that threads strained and sheared within the tolerances can have:
/// (1 + e) / (1 - e) sqrt((1 + sin g) / (1 - sin g)).
double allowed_stretch_ratio(const Tolerances& tolerances);

}  // namespace ripstop
