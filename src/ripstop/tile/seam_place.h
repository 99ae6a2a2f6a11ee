#pragma once

#include "ripstop/model/plan/cut_plan.h"
#include "ripstop/model/tile/boundary_place.h"
#include "ripstop/model/tile/seam_sheets.h"

namespace ripstop {

/// Where a seam's curve `along` [m] from its start lies on one of its sides. `tiles` are the envelope's; `second`: on
/// side b, which runs against the curve. Parts of edges lie where the seam's other side is in space (a T-junction
/// within an edge). O(#parts).
BoundaryPlace place_on_side(const std::vector<FlatTile>& tiles, const Seam& seam, bool second, double along);

/// The same of one of a seam's sheets, `along` from the start of the seam that it lies in.
BoundaryPlace place_on_sheet(const std::vector<FlatTile>& tiles, const SeamSheet& sheet, double along);

/// On the cloth.
Vec2 flat_point(const FlatTile& tile, const BoundaryPlace& place);

}  // namespace ripstop
