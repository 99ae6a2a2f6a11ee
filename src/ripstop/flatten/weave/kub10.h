#pragma once

#include "ripstop/flatten/weave/woven_mesh.h"

namespace ripstop {

/// Isotropic springs, which converge fastest.
inline constexpr WovenOptions kub10_options = {.warp_stiffness = 1, .weft_stiffness = 1};

/// The earlier system of the paper's authors [KZ, their Kub10]: the tile is projected onto a plane, and the woven
/// model refines the result. The source says only this and that it "depended heavily on the early surface
/// projection"; the rest is our interpretation.
///
/// The plane is normal to the tile's area vector. The weave lies on it with the warp along the grain, and each
/// crossing starts at the surface point above it, where the surface is at most 45 degrees steep. The crossings on the
/// surface are then too far apart, more so on steep parts. The springs of the woven model (`fit_woven_mesh`) contract
/// them, boundary propagation covers what they uncover, and the weave is read off as in `flatten_woven`. Compared
/// with that method, whose yarns start on straight lines of the surface, it shows the influence of the start.
///
/// Not exact on developable tiles: a weave that starts stretched converges slowly, and `options` determines when to
/// stop. Exact on plane tiles. Vertices that no crossing sees are laid on from their neighbours; the summary's reason
/// counts them. A tile that is steep in the middle (folded) gets no weave and is laid triangle by triangle.
///
/// Requires a disk (`make_tile`). Throws InputError if the options are out of range. Less than a second per thousand
/// triangles.
Flattening flatten_kub10(const Tile& tile, const WovenOptions& options = kub10_options);

}  // namespace ripstop
