#pragma once

#include <array>

#include "ripstop/geometry/types.h"

namespace ripstop {

/// The z component of a x b, positive where b turns left of a.
inline double cross(const Vec2& a, const Vec2& b) {
    return a.x() * b.y() - a.y() * b.x();
}

/// Signed area of a triangle [m2], positive if counter-clockwise.
double signed_area(const Vec2& a, const Vec2& b, const Vec2& c);
double triangle_area(const Vec3& a, const Vec3& b, const Vec3& c);

/// Lays a triangle in the plane: a at the origin, b on +x, c above. The columns of the result are b - a and c - a, so
/// the matrix is [[|ab|, x], [0, y]] with y >= 0. Intrinsic: it depends on the three edge lengths only.
Mat22 lay_flat(const Vec3& a, const Vec3& b, const Vec3& c);

/// The gradients N of the barycentric coordinates of a triangle given by its edges (columns). J = sum_k u_k N_k^T is
/// the Jacobian of the map that takes its corners to u_k.
Eigen::Matrix<double, 2, 3> corner_gradients(const Mat22& edges);

/// A N^T N: the cotangent stiffness matrix of a triangle, positive semi-definite.
Eigen::Matrix3d cotangent_matrix(const Mat22& edges);

/// Edge k of a triangle given by its edges b - a and c - a: from corner k to corner k + 1.
Vec2 triangle_edge(const Mat22& edges, int k);

/// The angle at `a` in [0, pi], accurate for slivers too (atan2 of cross and dot product).
double angle_at(const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace ripstop
