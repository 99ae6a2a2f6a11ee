#pragma once

#include "ripstop/model/plan/flattening.h"
#include "ripstop/model/tile/tile.h"

namespace ripstop {

struct EnergyReleaseOptions {
    double accuracy = 0.01;            ///< E_S and E_C below which no energy is released; > 0
    double energy_tolerance = 0.0005;  ///< at rest if a swing lowers the energy by less than this fraction; > 0
    int max_steps = 1000;              ///< steps for the whole tile, phase 2; >= 0
    int max_steps_laying = 50;         ///< steps per release in phase 1; >= 0
    double step = 0.7;                 ///< time step times the highest frequency, in (0, 1.4): stable below
    double penalty_below = 0.1;        ///< fraction of its height below which a triangle is pushed open, in [0, 1]
};

/// The flattening of Wang, Smith and Yuen [WSY02]: triangles are laid one by one, and springs of equal stiffness on
/// all edges release their energy.
///
///     E = sum_edges C/2 (|P_i P_j| - d_ij)^2,   d_ij the length on the surface                      (1), (3)
///     m_i = rho/3 sum A_k                        rho such that the lightest particle has mass 1      (10)
///     a = f / m,  v <- v + dt a,  q <- q + dt v + dt^2/2 a                                           (11) to (13)
///
/// Phase 1 lays triangle by triangle outward from the middle. A new vertex is placed where two circles meet; an
/// existing one moves to the mean of its place and the place that the new triangle wants. Up to `max_steps_laying`
/// steps of the laid part follow. Phase 2 takes up to `max_steps` steps of the whole tile. Both stop once E_S = sum
/// |A - A'| / sum A and E_C = sum |L - L'| / sum L are within `accuracy`, so a tile that is accurate after laying is
/// not changed again; a developable one is exact. Isotropic, free boundary.
///
/// Differences from the source: with its typical time step 0.01 (C = 0.5) its criterion |dE| / E < 0.05 % holds after
/// two steps, far from rest. Here the step follows the highest frequency, the criterion applies to whole swings, and
/// the velocities are dropped after each. Its penalty (14) pushes every triangle that is lower than on the surface,
/// which keeps compressed cloth away from rest; here it starts at `penalty_below` of the height. Phase 1 releases
/// after every triangle up to 200, then whenever the laid part has grown by half a per cent, which keeps the cost
/// proportional to the tile.
///
/// Requires a disk (`make_tile`). Throws InputError if the options are out of range. The summary reports a reached
/// step limit and flipped triangles.
Flattening flatten_energy_release(const Tile& tile, const EnergyReleaseOptions& options = {});

}  // namespace ripstop
