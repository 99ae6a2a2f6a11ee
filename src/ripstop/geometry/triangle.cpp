#include "ripstop/geometry/triangle.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>

namespace ripstop {

double signed_area(const Vec2& a, const Vec2& b, const Vec2& c) {
    return 0.5 * cross(b - a, c - a);
}

double triangle_area(const Vec3& a, const Vec3& b, const Vec3& c) {
    return 0.5 * (b - a).cross(c - a).norm();
}

Mat22 lay_flat(const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 ab = b - a;
    const Vec3 ac = c - a;
    const double length = ab.norm();
    Mat22 flat = Mat22::Zero();
    if (length == 0) {
        flat(0, 1) = ac.norm();
        return flat;
    }
    flat(0, 0) = length;
    flat(0, 1) = ab.dot(ac) / length;
    flat(1, 1) = ab.cross(ac).norm() / length;
    return flat;
}

Eigen::Matrix<double, 2, 3> corner_gradients(const Mat22& edges) {
    Eigen::Matrix<double, 2, 3> gradients;
    gradients.rightCols<2>() = edges.inverse().transpose();
    gradients.col(0) = -gradients.col(1) - gradients.col(2);
    return gradients;
}

Eigen::Matrix3d cotangent_matrix(const Mat22& edges) {
    const Eigen::Matrix<double, 2, 3> gradients = corner_gradients(edges);
    return 0.5 * edges.determinant() * gradients.transpose() * gradients;
}

Vec2 triangle_edge(const Mat22& edges, int k) {
    if (k == 0) return edges.col(0);
    return k == 1 ? Vec2(edges.col(1) - edges.col(0)) : Vec2(-edges.col(1));
}

double angle_at(const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 ab = b - a;
    const Vec3 ac = c - a;
    return std::atan2(ab.cross(ac).norm(), ab.dot(ac));
}

}  // namespace ripstop
