#pragma once

#include "ripstop/model/plan/flattening.h"
#include "ripstop/model/tile/tile.h"

namespace ripstop {

struct WireWarpingOptions {
    int max_iterations = 50;  ///< Newton steps, then as many minimum-norm steps where these vibrate; > 0
};

/// A closed line of given edge lengths whose turnings are as near as may be to wanted ones.
struct ClosedWire {
    Points2 line;             ///< #B x 2, from the origin, the first edge along +x [m]
    Eigen::VectorXd turning;  ///< #B [rad]
    int iterations = 0;
    bool closed = false;        ///< the line meets its start to 1e-11 of its length
    bool minimum_norm = false;  ///< some line near the wanted turnings: the nearest one was not found
};

/// The wire of [W08]: with theta the inner angles of the closed line and alpha those on the surface,
///
///     minimise 1/2 sum (theta_i - alpha_i)^2,  sum theta_i = (n - 2) pi,  sum l_i (cos phi_i, sin phi_i) = 0
///
/// phi_i the direction of edge i, l_i its length, held. Newton's method on the first-order conditions with the
/// curvature of the constraints left out: a system of 3 unknowns a step. Where that does not come to rest, the
/// minimum-norm steps of [W09] go on from the wanted turnings to some line that closes. `lengths`, `wanted` (#B): edge
/// i runs from vertex i, turning i = pi - theta_i is there. Requires at least three edges, none longer than the others
/// together.
ClosedWire warp_wire(const Eigen::VectorXd& lengths, const Eigen::VectorXd& wanted,
                     const WireWarpingOptions& options = {});

/// WireWarping [W08] with the boundary as its only wire: every edge of the outline exactly as long as it is to be, its
/// turnings as near as may be to those on the surface, the inside by the Laplacian weighted with the inverse edge
/// lengths.
///
/// The outline is exact on developable tiles; the inside is not shaped there or anywhere (the weights know lengths,
/// not angles). The objective asks turnings to stay what they are, but on curved tiles they must take up the curvature
/// inside: spread evenly it makes the geodesic sides of a gore circular arcs, a lens whose area is pi^2/12 - 1 = -17.8
/// % off however narrow the gore. Isotropic.
///
/// Requires a disk (`make_tile`). O(#B) a step and one factorisation. A line that does not close, the minimum-norm way
/// out and flipped triangles (an outline that crosses itself has some) are said in the summary.
Flattening flatten_wirewarping(const Tile& tile, const WireWarpingOptions& options = {});

}  // namespace ripstop
