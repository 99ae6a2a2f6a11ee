#pragma once

#include "ripstop/model/bounds.h"
#include "ripstop/model/tile.h"
#include "ripstop/model/verdict.h"

namespace ripstop {

/// The disc is centred where the tile is deepest, and as large as straight lines from there fit into it; its edge is measured
/// along 360 of them, and is long by less than 2e-5 of it for that. O(#F log #F).
Bounds measure_bounds(const Tile& tile);

/// The largest ratio of principal stretches that threads strained and sheared within the tolerances can have:
/// (1 + e) / (1 - e) sqrt((1 + sin g) / (1 - sin g)).
double allowed_stretch_ratio(const Tolerances& tolerances);

}  // namespace ripstop
