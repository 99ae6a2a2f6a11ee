#pragma once

#include "ripstop/model/plan/cut_plan.h"
#include "ripstop/model/tile/boundary_place.h"
#include "ripstop/tile/seam_sheets.h"

namespace ripstop {

/// The place on one side of a seam that is `along` [m] from the start of the seam's curve. `tiles` are those of the
/// envelope. `second` selects side b, which runs against the curve. If only a part of an edge belongs to the seam (a
/// T-junction inside the edge), its position on the edge follows from the other side in space. O(#parts).
BoundaryPlace place_on_side(const std::vector<FlatTile>& tiles, const Seam& seam, bool second, double along);

/// The same for one sheet of a seam, `along` from the start of the seam that contains it.
BoundaryPlace place_on_sheet(const std::vector<FlatTile>& tiles, const SeamSheet& sheet, double along);

/// The place on the cloth.
Vec2 flat_point(const FlatTile& tile, const BoundaryPlace& place);

}  // namespace ripstop
