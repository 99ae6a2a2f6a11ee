#include "ripstop/energy/boundary_bending.h"

#include <cmath>

#include "ripstop/geometry/triangle.h"

namespace ripstop {
namespace {

/// First and second derivatives of the direction angle atan2(y, x) of an edge.
Vec2 angle_gradient(const Vec2& d) {
    return Vec2(-d.y(), d.x()) / d.squaredNorm();
}

Mat22 angle_hessian(const Vec2& d) {
    const double r4 = d.squaredNorm() * d.squaredNorm();
    const double xy = 2 * d.x() * d.y() / r4;
    const double yy_xx = (d.y() * d.y() - d.x() * d.x()) / r4;
    Mat22 hessian;
    hessian << xy, yy_xx, yy_xx, -xy;
    return hessian;
}

}  // namespace

double turning(const Vec2& previous, const Vec2& vertex, const Vec2& next) {
    const Vec2 arriving = vertex - previous;
    const Vec2 leaving = next - vertex;
    return std::atan2(cross(arriving, leaving), arriving.dot(leaving));
}

BendingElement boundary_bending(const Vec2& previous, const Vec2& vertex, const Vec2& next, double reference,
                                double stiffness, double length, bool semidefinite) {
    const double k = stiffness / length;
    const double excess = turning(previous, vertex, next) - reference;
    const Vec2 arriving = angle_gradient(vertex - previous);
    const Vec2 leaving = angle_gradient(next - vertex);
    // turning = angle(next - vertex) - angle(vertex - previous)
    Eigen::Matrix<double, 6, 1> slope;
    slope << arriving, -leaving - arriving, leaving;
    BendingElement element;
    element.energy = 0.5 * k * excess * excess;
    element.gradient = k * excess * slope;
    element.hessian = k * slope * slope.transpose();
    if (semidefinite) return element;
    const Mat22 in = k * excess * angle_hessian(vertex - previous);
    const Mat22 out = k * excess * angle_hessian(next - vertex);
    element.hessian.block<2, 2>(0, 0) -= in;
    element.hessian.block<2, 2>(0, 2) += in;
    element.hessian.block<2, 2>(2, 0) += in;
    element.hessian.block<2, 2>(2, 2) += out - in;
    element.hessian.block<2, 2>(2, 4) -= out;
    element.hessian.block<2, 2>(4, 2) -= out;
    element.hessian.block<2, 2>(4, 4) += out;
    return element;
}

}  // namespace ripstop
