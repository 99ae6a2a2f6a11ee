#pragma once

#include <Eigen/Core>

#include "ripstop/geometry/types.h"

namespace ripstop {

/// How the energy of a tape between two points changes as they move: unknowns (ax, ay, az, bx, by, bz).
struct TapeElement {
    double energy = 0;                                                           ///< [J]
    Eigen::Matrix<double, 6, 1> gradient = Eigen::Matrix<double, 6, 1>::Zero();  ///< [N]
    Eigen::Matrix<double, 6, 6> hessian = Eigen::Matrix<double, 6, 6>::Zero();   ///< [N/m]
};

/// A straight piece of tape, rope or wire that pulls and never pushes, in Green strain:
///
///     e = (l^2 / L^2 - 1) / 2,  energy = L EA <e>+^2 / 2
///
/// L [m] its length at rest, EA [N] its stiffness. The Hessian is positive semi-definite.
TapeElement tape_element(double stiffness, double rest, const Vec3& a, const Vec3& b);

/// The energy alone [J].
double tape_energy(double stiffness, double rest, const Vec3& a, const Vec3& b);

/// The force it pulls with: EA e l / L, 0 where slack [N].
double tape_force(double stiffness, double rest, const Vec3& a, const Vec3& b);

}  // namespace ripstop
