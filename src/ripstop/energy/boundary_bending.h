#pragma once

#include "ripstop/geometry/types.h"

namespace ripstop {

/// How the energy of one boundary vertex changes as it and its two neighbours move: unknowns (px, py, vx, vy, nx, ny).
struct BendingElement {
    double energy = 0;                                                           ///< [J]
    Eigen::Matrix<double, 6, 1> gradient = Eigen::Matrix<double, 6, 1>::Zero();  ///< [N]
    Eigen::Matrix<double, 6, 6> hessian = Eigen::Matrix<double, 6, 6>::Zero();   ///< [N/m]
};

/// The angle by which the polyline p, v, n turns left at v, in (-pi, pi] [rad].
double turning(const Vec2& previous, const Vec2& vertex, const Vec2& next);

/// Bending of the cut line at one vertex: b/2 (turning - reference)^2 / length, length that of the line which belongs
/// to the vertex. Without it, exact edges on a saddle would rather fold into a zig-zag than strain the cloth. The
/// Hessian is exact; `semidefinite` leaves out the part that can be negative (Gauss-Newton). Stiffness b in J m, length
/// in m, reference in rad. Requires three different points.
BendingElement boundary_bending(const Vec2& previous, const Vec2& vertex, const Vec2& next, double reference,
                                double stiffness, double length, bool semidefinite);

}  // namespace ripstop
