#pragma once

#include "ripstop/model/plan/flattening.h"
#include "ripstop/model/tile/tile.h"

namespace ripstop {

struct EnergyReleaseOptions {
    double accuracy = 0.01;            ///< E_S and E_C below which nothing is released; > 0
    double energy_tolerance = 0.0005;  ///< at rest when a swing lowers the energy by less than this part; > 0
    int max_steps = 1000;              ///< of the whole tile, phase 2; >= 0
    int max_steps_laying = 50;         ///< each time in phase 1; >= 0
    double step = 0.7;                 ///< time step times the fastest frequency, in (0, 1.4): stable below
    double penalty_below = 0.1;        ///< share of its height below which a triangle is pushed open, in [0, 1]
};

/// The flattening of Wang, Smith and Yuen [WSY02]: triangles are laid down one by one, and springs of equal stiffness
/// on all edges release their energy.
///
///     E = sum_edges C/2 (|P_i P_j| - d_ij)^2,   d_ij the length on the surface                      (1), (3)
///     m_i = rho/3 sum A_k                        rho such that the lightest particle has mass 1      (10)
///     a = f / m,  v <- v + dt a,  q <- q + dt v + dt^2/2 a                                           (11) to (13)
///
/// Phase 1 lays triangle by triangle outward from the middle: a new vertex where two circles meet, one that is there
/// already goes to the mean of where it is and where the new triangle would have it; then up to `max_steps_laying`
/// steps of what is laid. Phase 2: up to `max_steps` of the whole. Either stops once E_S = sum |A - A'| / sum A and
/// E_C = sum |L - L'| / sum L are both within `accuracy`, so a tile that lies well enough after laying is not touched
/// again; a developable one is exact. Isotropic, boundary free.
///
/// Other than the source: its typical time step 0.01 (C = 0.5) meets the stop |dE| / E < 0.05 % after two steps, far
/// from rest, so the step follows the fastest frequency and the stop is asked of whole swings, after which the
/// velocities are dropped. Its penalty (14) pushes every triangle that is lower than on the surface by all it lacks,
/// which holds compressed cloth away from rest; here it begins at `penalty_below` of the height. Phase 1 releases
/// after every triangle up to 200 and then each time the laid part has grown by half a per cent, which keeps the cost
/// proportional to the tile.
///
/// Requires a disk (`make_tile`). Throws InputError for options out of range. The limit of steps and flipped triangles
/// are said in the summary.
Flattening flatten_energy_release(const Tile& tile, const EnergyReleaseOptions& options = {});

}  // namespace ripstop
