#pragma once

#include "ripstop/report/view/map_view.h"

namespace ripstop {

/// The tile that the page shows first: of those that fail the one with the largest excess; else, where a seam fails,
/// the first side of the worst; else the one with the largest value of `view` against its scale. Of equal ones that
/// which faces the viewer of the whole most. -1 without tiles.
int first_tile(const CutPlan& plan, const MapView& view);

}  // namespace ripstop
