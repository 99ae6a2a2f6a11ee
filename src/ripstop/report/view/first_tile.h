#pragma once

#include "ripstop/report/view/map_view.h"

namespace ripstop {

/// The tile that the page shows first: the failing tile with the largest excess; else, if a seam fails, side a of the
/// worst seam; else the tile with the largest value of `view` relative to its scale. Of equal tiles, the one that most
/// faces the viewer. -1 without tiles.
int first_tile(const CutPlan& plan, const MapView& view);

}  // namespace ripstop
