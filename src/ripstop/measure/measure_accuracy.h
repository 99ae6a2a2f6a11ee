#pragma once

#include "ripstop/model/plan/accuracy.h"
#include "ripstop/model/tile/fabric.h"
#include "ripstop/model/tile/tile.h"

namespace ripstop {

/// Measures a flattening (#V x 2) of a tile: the paper's metrics, those of its sources, strain, energy, flips and
/// overlaps. The reference is the surface with the tile's compensation. `edges_on_curve`: see `boundary_on_cloth`; no
/// other property of the method is used. About O(#F).
Accuracy measure_accuracy(const Tile& tile, const Points2& flat, const Fabric& fabric, bool edges_on_curve = true);

}  // namespace ripstop
