#pragma once

#include <string>

#include "ripstop/model/plan/flattening.h"
#include "ripstop/model/tile/tile.h"

namespace ripstop {

/// Scales flat positions (#V x 2) so that their signed area equals the surface area; no change if it is not positive.
void scale_to_area(const TriangleMesh& mesh, Points2& positions);

/// Rotates a flattening to its grain and fills in its summary: `reason`, followed by the number of flipped triangles
/// if there are any. The termination becomes `failed` if a position is not finite.
void finish(const Tile& tile, Flattening& flat, Termination termination, const std::string& reason);

}  // namespace ripstop
