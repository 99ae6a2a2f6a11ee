#pragma once

#include "ripstop/flatten/weave/woven_mesh.h"

namespace ripstop {

/// Springs alike in all directions, which rest soonest.
inline constexpr WovenOptions kub10_options = {.warp_stiffness = 1, .weft_stiffness = 1};

/// The earlier system of the paper's authors [KZ, their Kub10]: the tile is projected on a plane, and the woven model
/// refines that. All that is known is this and that it "depended heavily on the early surface projection"; the rest is
/// our reading.
///
/// The plane is across the tile's area vector, the weave lies on it with the warp along the grain, and each crossing
/// starts where its projection meets the surface, as far as that is at most 45 degrees steep. On the surface crossings
/// are then too far apart, the more the steeper it is: the springs of the woven model (`fit_woven_mesh`) draw them
/// together, boundary propagation covers what is bared, and the weave is read off as by `flatten_woven`. Beside that
/// method, whose yarns start on straight lines of the surface, it shows what the start is worth.
///
/// Not exact on developable tiles: a weave that begins stretched comes to rest only slowly, and `options` says when to
/// stop. Exact on plane ones. Vertices that no crossing sees are laid on from their neighbours; the summary's reason
/// counts them. A tile that is steep in the middle (folded) gets no weave at all and is laid triangle by triangle.
///
/// Requires a disk (`make_tile`). Throws InputError for options out of range. Under a second a thousand triangles.
Flattening flatten_kub10(const Tile& tile, const WovenOptions& options = kub10_options);

}  // namespace ripstop
