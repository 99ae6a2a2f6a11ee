#pragma once

#include "ripstop/geometry/types.h"

namespace ripstop {

/// Energy, gradient and Hessian of one boundary vertex and its two neighbours: unknowns (px, py, vx, vy, nx, ny).
struct BendingElement {
    double energy = 0;                                                           ///< [J]
    Eigen::Matrix<double, 6, 1> gradient = Eigen::Matrix<double, 6, 1>::Zero();  ///< [N]
    Eigen::Matrix<double, 6, 6> hessian = Eigen::Matrix<double, 6, 6>::Zero();   ///< [N/m]
};

/// The angle by which the polyline p, v, n turns left at v, in (-pi, pi] [rad].
double turning(const Vec2& previous, const Vec2& vertex, const Vec2& next);

/// The bending energy of the cut line at one vertex: b/2 (turning - reference)^2 / length, where `length` is the part
/// of the line that belongs to the vertex. Without it, exact edges on a saddle fold into a zigzag rather than strain
/// the cloth. The Hessian is exact; `semidefinite` drops the part that can be negative (Gauss-Newton). Stiffness b in
/// J m, length in m, reference in rad. Requires three distinct points.
BendingElement boundary_bending(const Vec2& previous, const Vec2& vertex, const Vec2& next, double reference,
                                double stiffness, double length, bool semidefinite);

}  // namespace ripstop
