#pragma once

#include "ripstop/model/plan/flattening.h"
#include "ripstop/model/tile/tile.h"

namespace ripstop {

struct WireWarpingOptions {
    int max_iterations = 50;  ///< Newton steps, then as many minimum-norm steps if those oscillate; > 0
};

/// A closed line with given edge lengths and turnings as close as possible to wanted ones.
struct ClosedWire {
    Points2 line;             ///< #B x 2, from the origin, the first edge along +x [m]
    Eigen::VectorXd turning;  ///< #B [rad]
    int iterations = 0;
    bool closed = false;        ///< the line meets its start to within 1e-11 of its length
    bool minimum_norm = false;  ///< the nearest line was not found; this is some line near the wanted turnings
};

/// The closed wire of [W08]. With theta the inner angles of the closed line and alpha those on the surface,
///
///     minimise 1/2 sum (theta_i - alpha_i)^2,  sum theta_i = (n - 2) pi,  sum l_i (cos phi_i, sin phi_i) = 0
///
/// where phi_i is the direction of edge i and l_i its fixed length. Newton's method on the first-order conditions,
/// without the curvature of the constraints: a system of 3 unknowns per step. If it does not converge, the
/// minimum-norm steps of [W09] lead from the wanted turnings to some closed line. `lengths`, `wanted` (#B): edge i
/// starts at vertex i, where the turning is pi - theta_i. Requires at least three edges, none longer than the others
/// together.
ClosedWire warp_wire(const Eigen::VectorXd& lengths, const Eigen::VectorXd& wanted,
                     const WireWarpingOptions& options = {});

/// WireWarping [W08] with the boundary as the only wire: every edge of the outline has exactly its target length, its
/// turnings are as close as possible to those on the surface, and the interior follows from a Laplacian weighted with
/// the inverse edge lengths.
///
/// The outline is exact on developable tiles. The interior never is, because the weights depend on lengths and not on
/// angles. The objective keeps the turnings, but on a curved tile they must absorb the curvature inside. Spread
/// evenly, it turns the geodesic sides of a gore into circular arcs: a lens whose area is pi^2/12 - 1 = -17.8 % off,
/// however narrow the gore. Isotropic.
///
/// Requires a disk (`make_tile`). O(#B) per step and one factorisation. The summary reports a line that does not
/// close, the use of minimum-norm steps, and flipped triangles (an outline that crosses itself has some).
Flattening flatten_wirewarping(const Tile& tile, const WireWarpingOptions& options = {});

}  // namespace ripstop
