#include "ripstop/energy/deformation.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace ripstop {

TriangleMetric triangle_metric(const Vec3& a, const Vec3& b, const Vec3& c) {
    return {(b - a).squaredNorm(), (b - a).dot(c - a), (c - a).squaredNorm()};
}

TriangleMetric triangle_metric(const Mat22& edges) {
    return {edges.col(0).squaredNorm(), edges.col(0).dot(edges.col(1)), edges.col(1).squaredNorm()};
}

Mat22 flat_edges(const Triangles& triangles, const Points2& positions, int triangle) {
    const Vec2 a = positions.row(triangles(triangle, 0));
    Mat22 flat;
    flat.col(0) = positions.row(triangles(triangle, 1)).transpose() - a;
    flat.col(1) = positions.row(triangles(triangle, 2)).transpose() - a;
    return flat;
}

Mat22 cauchy_green(const TriangleMetric& metric, const Mat22& flat) {
    const Mat22 inverse = flat.inverse();
    Mat22 gram;
    gram << metric.aa, metric.ab, metric.ab, metric.bb;
    return inverse.transpose() * gram * inverse;
}

ThreadStrain thread_strain(const TriangleMetric& metric, const Mat22& flat) {
    const Mat22 stretch = cauchy_green(metric, flat);
    const double warp = std::sqrt(stretch(0, 0));
    const double weft = std::sqrt(stretch(1, 1));
    if (!stretch.allFinite()) {
        constexpr double infinite = std::numeric_limits<double>::infinity();
        return {infinite, infinite, std::numbers::pi / 2};
    }
    return {warp - 1, weft - 1, std::asin(std::clamp(stretch(0, 1) / (warp * weft), -1.0, 1.0))};
}

}  // namespace ripstop
