#pragma once

#include <vector>

#include "ripstop/flatten/weave/woven_mesh.h"
#include "ripstop/mesh/geodesic.h"

namespace ripstop {

/// A crossing of the weave on the surface: warp yarns count up with `weft`, along each of them crossings with `warp`.
struct WovenNode {
    SurfacePoint at;
    int warp = 0;         ///< steps along the warp from the centre
    int weft = 0;         ///< along the weft
    bool tendon = false;  ///< on one of the two yarns through the centre, which do not move
    bool placed = true;   ///< false: it left the surface
};

struct WovenFit {
    double spacing = 0;  ///< [m]
    std::vector<WovenNode> nodes;
    int iterations = 0;
    bool at_rest = false;
    double energy = 0;  ///< sum k (l - l0)^2 / 2 over the springs whose ends see each other [m2 x stiffness ratio]
};

/// The woven mesh of `spacing` fitted to the surface from `centre` with the warp along `warp` (in the frame of the
/// centre's triangle): tendons, diagonals quadrant by quadrant, boundary propagation, energy diffusion [WTY05, section
/// 3]. A grid position is taken once, and a place on the surface too: where fronts meet that went round a slit, they
/// stop. Tendons are as long as the surface lets them, but no more than `max_nodes` nodes are placed.
WovenFit fit_woven_mesh(const UnfoldedSurface& surface, const SurfacePoint& centre, const Vec2& warp, double spacing,
                        int max_nodes, const WovenOptions& options);

/// The same from crossings that lie on the surface already: of `start`, in its order, those that see a neighbour and
/// crowd none are placed (the first in any case, and it stays where it is), then boundary propagation and energy
/// diffusion.
WovenFit settle_woven_mesh(const UnfoldedSurface& surface, const std::vector<WovenNode>& start, double spacing,
                           int max_nodes, const WovenOptions& options);

/// How far a crossing looks for others: springs stretched by more than half count as broken [spacings].
inline constexpr double woven_reach = 2.2;

}  // namespace ripstop
