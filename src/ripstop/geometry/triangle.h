#pragma once

#include <array>

#include "ripstop/geometry/types.h"

namespace ripstop {

/// z of (b - a) x (c - a): twice the signed area, positive where a, b, c turn left.
inline double cross(const Vec2& a, const Vec2& b) {
    return a.x() * b.y() - a.y() * b.x();
}

/// Area of a triangle [m2]; in the plane it is positive counter-clockwise.
double signed_area(const Vec2& a, const Vec2& b, const Vec2& c);
double triangle_area(const Vec3& a, const Vec3& b, const Vec3& c);

/// The triangle laid in the plane: a at the origin, b on +x, c above. Columns of the result are b - a and c - a, so the
/// matrix is [[|ab|, x], [0, y]] with y >= 0. Intrinsic: it knows only the three lengths.
Mat22 lay_flat(const Vec3& a, const Vec3& b, const Vec3& c);

/// The gradients of the three corner functions of a triangle given by its edges (columns): J = sum_k u_k N_k^T is the
/// Jacobian of the map that takes its corners to u_k.
Eigen::Matrix<double, 2, 3> corner_gradients(const Mat22& edges);

/// A N^T N: the triangle's share of the cotangent matrix, the Laplacian of piecewise linear functions (positive).
Eigen::Matrix3d cotangent_matrix(const Mat22& edges);

/// Edge k of a triangle given by its edges b - a and c - a: from corner k to corner k + 1.
Vec2 triangle_edge(const Mat22& edges, int k);

/// The angle at `a` in [0, pi], accurate for needles too (atan2 of cross and dot).
double angle_at(const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace ripstop
