#pragma once

#include <string>

#include "ripstop/flatten/weave/woven_fit.h"
#include "ripstop/model/plan/flattening.h"
#include "ripstop/model/tile/tile.h"

namespace ripstop {

/// Reads the flat vertex positions off a weave on the surface and rotates them to the grain.
///
/// Each crossing extends its plane coordinates over the region it sees by the affine map that takes its neighbours to
/// their grid places; a vertex takes the mean with weights (1 / distance - 1 / reach)^2. Vertices that no crossing
/// sees are laid on from their neighbours (`lay_on_missing`); with fewer than nine crossings the whole tile is laid
/// from the triangle `seed`. Flipped triangles are repaired where possible. `termination` and `reason` go to the
/// summary; the reason also counts the vertices laid on and the triangles flipped and repaired. The termination
/// becomes `failed` if a position is not finite.
Flattening read_weave(const Tile& tile, const Adjacency& adjacency, const UnfoldedSurface& surface, const WovenFit& fit,
                      int seed, Termination termination, const std::string& reason);

/// The number of crossings on the surface.
int count_crossings(const WovenFit& fit);

/// `812 crossings of the weave at rest`
std::string weave_ending(const WovenFit& fit);

}  // namespace ripstop
