#pragma once

#include <Eigen/Core>

#include "ripstop/geometry/types.h"

namespace ripstop {

/// Energy, gradient and Hessian of a tape between two points: unknowns (ax, ay, az, bx, by, bz).
struct TapeElement {
    double energy = 0;                                                           ///< [J]
    Eigen::Matrix<double, 6, 1> gradient = Eigen::Matrix<double, 6, 1>::Zero();  ///< [N]
    Eigen::Matrix<double, 6, 6> hessian = Eigen::Matrix<double, 6, 6>::Zero();   ///< [N/m]
};

/// A straight piece of tape, rope or wire that carries tension only, in Green strain:
///
///     e = (l^2 / L^2 - 1) / 2,  energy = L EA <e>+^2 / 2
///
/// L [m] is its length at rest, EA [N] its stiffness. The Hessian is positive semi-definite.
TapeElement tape_element(double stiffness, double rest, const Vec3& a, const Vec3& b);

/// The energy only [J].
double tape_energy(double stiffness, double rest, const Vec3& a, const Vec3& b);

/// The tension EA e l / L, 0 if slack [N].
double tape_force(double stiffness, double rest, const Vec3& a, const Vec3& b);

}  // namespace ripstop
