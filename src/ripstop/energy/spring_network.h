#pragma once

#include <vector>

#include "ripstop/model/tile/fabric.h"
#include "ripstop/model/tile/tile.h"

namespace ripstop {

/// A spring between two vertices.
struct Spring {
    int a = 0, b = 0;
    double rest = 0;       ///< length on the surface [m]
    double stiffness = 0;  ///< [N/m]
};

/// The paper's fabric: particles at a tile's vertices, a spring along each edge of its mesh.
///
///     E(u) = sum_springs k/2 (|u_b - u_a| - l0)^2 + sum_triangles c/2 max(0, 0.3 - a/a0)^2
///
/// Stiffness follows the warp and weft share of the spring, which is the part of the paper's eqs (1), (2) along the
/// spring (the part across it is no gradient of any energy, so it cannot come to rest):
///
///     k = sum_t A_t (E_warp cos^2 + E_weft sin^2) / l0^2        over the triangles at the edge, cos = edge · warp
///
/// Masses are a third of the triangles' at each particle [WSY02, eq. 10], more where a particle would swing faster than
/// the median one: small triangles would else dictate the time step, and rest does not depend on mass. The second sum
/// is zero until a triangle has lost 70 % of its area (a on the cloth, a0 on the surface): it plays the part of the
/// penalty against overlap of [WSY02, eq. 14] and turns flipped triangles back. Springs alone force c12 = c33 whatever
/// k is: see `implied_elasticity`.
struct SpringNetwork {
    std::vector<Spring> springs;
    Eigen::VectorXd mass;             ///< #V [kg]
    Triangles triangles;              ///< #F x 3
    Eigen::VectorXd rest_area;        ///< #F [m2]
    Eigen::VectorXd guard_stiffness;  ///< #F, c [J]
};

/// The network of a tile: a spring for each edge of its mesh, with the stiffness that the fabric gives it.
SpringNetwork make_spring_network(const Tile& tile, const Fabric& fabric);

/// E [J].
double energy(const SpringNetwork& network, const Points2& positions);

/// -dE/du and, where `velocities` is given, the dampers along the springs, force -tau k (dv·d) d with d the unit vector
/// of the spring; tau [s] is one time for all springs. #V x 2 [N]. Returns E; `forces` is overwritten.
double energy_and_forces(const SpringNetwork& network, const Points2& positions, const Points2& velocities, double tau,
                         Points2& forces);

/// A bound from above on the fastest natural frequency of the springs, sqrt(max_i 2 sum k / m_i) [rad/s].
double frequency_bound(const SpringNetwork& network);

/// The elasticity in (warp, weft, shear) that the springs stand for, averaged over the tile's area [N/m]:
/// C = sum_springs k l0^2 m m^T / A, m = (cos^2, sin^2, cos sin). Its entries (1,2) and (3,3) are always equal.
Eigen::Matrix3d implied_elasticity(const SpringNetwork& network, const Tile& tile);

}  // namespace ripstop
