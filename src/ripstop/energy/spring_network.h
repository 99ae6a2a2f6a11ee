#pragma once

#include <vector>

#include "ripstop/model/tile/fabric.h"
#include "ripstop/model/tile/tile.h"

namespace ripstop {

/// A spring between two vertices.
struct Spring {
    int a = 0, b = 0;
    double rest = 0;       ///< rest length, as on the surface [m]
    double stiffness = 0;  ///< [N/m]
};

/// The paper's model of cloth: particles at a tile's vertices and a spring along each edge of its mesh.
///
///     E(u) = sum_springs k/2 (|u_b - u_a| - l0)^2 + sum_triangles c/2 max(0, 0.3 - a/a0)^2
///
/// The stiffness depends on the direction of the spring relative to warp and weft. It is the component of the paper's
/// eqs (1), (2) along the spring; the component across it is not the gradient of any energy, so it could not come to
/// rest:
///
///     k = sum_t A_t (E_warp cos^2 + E_weft sin^2) / l0^2        over the triangles at the edge, cos = edge · warp
///
/// Each particle has a third of the mass of its triangles [WSY02, eq. 10]. The mass is increased if the particle
/// would oscillate faster than the median one: otherwise small triangles would determine the time step, and the rest
/// state does not depend on mass. The second sum is zero until a triangle has lost 70 % of its area (a on the cloth,
/// a0 on the surface). It replaces the overlap penalty of [WSY02, eq. 14] and turns flipped triangles back. Springs
/// alone imply c12 = c33 for any k: see `implied_elasticity`.
struct SpringNetwork {
    std::vector<Spring> springs;
    Eigen::VectorXd mass;             ///< #V [kg]
    Triangles triangles;              ///< #F x 3
    Eigen::VectorXd rest_area;        ///< #F [m2]
    Eigen::VectorXd guard_stiffness;  ///< #F, c [J]
};

/// The spring network of a tile: a spring for each edge of its mesh, with the stiffness of the fabric.
SpringNetwork make_spring_network(const Tile& tile, const Fabric& fabric);

/// E [J].
double energy(const SpringNetwork& network, const Points2& positions);

/// Writes -dE/du to `forces` (#V x 2 [N]) and returns E. If `velocities` is given, adds the damping along the
/// springs, -tau k (dv·d) d, where d is the unit vector of the spring and tau [s] the damping time, the same for all
/// springs.
double energy_and_forces(const SpringNetwork& network, const Points2& positions, const Points2& velocities, double tau,
                         Points2& forces);

/// An upper bound on the highest natural frequency of the springs, sqrt(max_i 2 sum k / m_i) [rad/s].
double frequency_bound(const SpringNetwork& network);

/// The membrane elasticity (warp, weft, shear) that the springs imply, averaged over the tile's area [N/m]:
/// C = sum_springs k l0^2 m m^T / A, m = (cos^2, sin^2, cos sin). Its entries (1,2) and (3,3) are always equal.
Eigen::Matrix3d implied_elasticity(const SpringNetwork& network, const Tile& tile);

}  // namespace ripstop
