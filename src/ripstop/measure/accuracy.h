#pragma once

#include "ripstop/model/plan/accuracy.h"
#include "ripstop/model/tile/fabric.h"
#include "ripstop/model/tile/tile.h"

namespace ripstop {

/// All the figures of a flattening (#V x 2) of a tile: the paper's metrics, those of its sources, strain, energy, flips
/// and overlaps, against what the cloth is to be: the surface, longer or shorter by the tile's compensation.
/// `edges_on_curve`: see `boundary_on_cloth`; nothing else is known of how the flattening was made. About O(#F).
Accuracy measure_accuracy(const Tile& tile, const Points2& flat, const Fabric& fabric, bool edges_on_curve = true);

}  // namespace ripstop
