#pragma once

#include <string>

#include "ripstop/flatten/weave/woven_fit.h"
#include "ripstop/model/plan/flattening.h"
#include "ripstop/model/tile/tile.h"

namespace ripstop {

/// Reads off a weave on the surface where it puts the tile's vertices, and turns that to the grain.
///
/// Each crossing spreads its plane coordinates over what it sees, by the affine map that takes its neighbours to
/// theirs; a vertex takes the mean, weighted (1 / distance - 1 / reach)^2. Vertices that no crossing sees are laid on
/// from their neighbours (`lay_on_missing`), all of them from the triangle `seed` where there are fewer than nine
/// crossings; flipped triangles are repaired where that goes. `termination` and `reason` become the summary's; the
/// reason also counts what was laid on, flipped and repaired. Failed where a position is not finite.
Flattening read_weave(const Tile& tile, const Adjacency& adjacency, const UnfoldedSurface& surface, const WovenFit& fit,
                      int seed, Termination termination, const std::string& reason);

/// Crossings of the weave that are on the surface.
int count_crossings(const WovenFit& fit);

/// `812 crossings of the weave at rest`
std::string weave_ending(const WovenFit& fit);

}  // namespace ripstop
