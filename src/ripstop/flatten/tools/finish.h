#pragma once

#include <string>

#include "ripstop/model/plan/flattening.h"
#include "ripstop/model/tile/tile.h"

namespace ripstop {

/// Scales flat positions (#V x 2) so that their signed area is the surface's. Left as they are where that is not
/// positive.
void scale_to_area(const TriangleMesh& mesh, Points2& positions);

/// Turns a flattening to its grain and says in its summary how it ended: `reason`, with the number of flipped triangles
/// behind it if there are any. Failed where a position is not finite.
void finish(const Tile& tile, Flattening& flat, Termination termination, const std::string& reason);

}  // namespace ripstop
