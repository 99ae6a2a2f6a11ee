#pragma once

#include <vector>

#include "ripstop/flatten/weave/woven_mesh.h"
#include "ripstop/mesh/geodesic.h"

namespace ripstop {

/// A crossing of the weave on the surface. `weft` counts the warp yarns, `warp` the crossings along each of them.
struct WovenNode {
    SurfacePoint at;
    int warp = 0;         ///< steps along the warp from the centre
    int weft = 0;         ///< steps along the weft
    bool tendon = false;  ///< on one of the two fixed yarns through the centre
    bool placed = true;   ///< false: it has left the surface
};

struct WovenFit {
    double spacing = 0;  ///< [m]
    std::vector<WovenNode> nodes;
    int iterations = 0;
    bool at_rest = false;
    double energy = 0;  ///< sum k (l - l0)^2 / 2 over the springs whose ends see each other [m2 x stiffness ratio]
};

/// Fits a woven mesh of `spacing` to the surface, from `centre` with the warp along `warp` (in the frame of the
/// centre's triangle): tendons, diagonals quadrant by quadrant, boundary propagation, energy diffusion [WTY05,
/// section 3]. Each grid position and each place on the surface is used once; fronts that have gone round a slit stop
/// where they meet. Tendons end at the boundary. At most `max_nodes` nodes are placed.
WovenFit fit_woven_mesh(const UnfoldedSurface& surface, const SurfacePoint& centre, const Vec2& warp, double spacing,
                        int max_nodes, const WovenOptions& options);

/// The same, starting from crossings that lie on the surface already. Takes those of `start`, in order, that see a
/// neighbour and are not too close to another one; the first is always taken, and fixed. Boundary propagation and
/// energy diffusion follow.
WovenFit settle_woven_mesh(const UnfoldedSurface& surface, const std::vector<WovenNode>& start, double spacing,
                           int max_nodes, const WovenOptions& options);

/// The range of a crossing: springs stretched by more than half count as broken [spacings].
inline constexpr double woven_reach = 2.2;

}  // namespace ripstop
