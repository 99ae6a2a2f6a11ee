#include "ripstop/assembly/faults/tile_fit.h"

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>

namespace ripstop {
namespace {

/// The least-squares similarity between paired points [U91].
Similarity best_similarity(const Points3& from, const Points3& to, bool with_scale) {
    const Vec3 centre_from = from.colwise().mean(), centre_to = to.colwise().mean();
    const Points3 a = from.rowwise() - centre_from.transpose(), b = to.rowwise() - centre_to.transpose();
    const Eigen::Matrix3d covariance = b.transpose() * a;
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Vec3 sign = Vec3::Ones();
    if (svd.matrixU().determinant() * svd.matrixV().determinant() < 0) sign[2] = -1;
    Similarity best;
    best.turn = svd.matrixU() * sign.asDiagonal() * svd.matrixV().transpose();
    if (with_scale && a.squaredNorm() > 0) best.scale = svd.singularValues().dot(sign) / a.squaredNorm();
    best.shift = centre_to - best.scale * (best.turn * centre_from);
    return best;
}

Vec3 nearest(const std::vector<TargetEdge>& edges, const Vec3& point) {
    double best_bound = std::numeric_limits<double>::infinity();
    const TargetEdge* best = nullptr;
    for (const TargetEdge& target : edges) {
        const Vec3 start = target.curve->points.row(target.edge);
        const Vec3 chord = Vec3(target.curve->points.row(target.edge + 1)) - start;
        const double t = std::clamp((point - start).dot(chord) / chord.squaredNorm(), 0.0, 1.0);
        const double distance = (point - start - t * chord).norm();
        if (distance >= best_bound) continue;
        best_bound = distance;
        best = &target;
    }
    return point_at(*best->curve, foot_on_edge(*best->curve, best->edge, point).at);
}

/// Length, centre and spread of a closed polygon.
struct Outline {
    double length = 0, spread = 0;
    Vec3 centre = Vec3::Zero();
};
Outline measure_outline(const Points3& polygon) {
    Outline outline;
    const auto each_side = [&](auto&& use) {
        for (Eigen::Index i = 0; i < polygon.rows(); ++i)
            use(Vec3(polygon.row(i)), Vec3(polygon.row((i + 1) % polygon.rows())));
    };
    each_side([&](const Vec3& p, const Vec3& q) {
        outline.length += (q - p).norm();
        outline.centre += (q - p).norm() * (p + q) / 2;
    });
    outline.centre /= outline.length;
    double moment = 0;
    each_side([&](const Vec3& p, const Vec3& q) {
        const Vec3 a = p - outline.centre, b = q - outline.centre;
        moment += (q - p).norm() * (a.squaredNorm() + a.dot(b) + b.squaredNorm()) / 3;
    });
    outline.spread = std::sqrt(moment / outline.length);
    return outline;
}

}  // namespace

TileFit fit_to_edges(const Points3& points, const std::vector<TargetEdge>& edges, const Similarity& start,
                     bool with_scale) {
    TileFit fit;
    fit.move = start;
    Points3 feet(points.rows(), 3);
    double before = std::numeric_limits<double>::infinity();
    for (int step = 0; step < 60; ++step) {
        double sum = 0;
        fit.residual = 0;
        for (Eigen::Index i = 0; i < points.rows(); ++i) {
            const Vec3 moved = fit.move(points.row(i).transpose());
            const Vec3 foot = nearest(edges, moved);
            feet.row(i) = foot;
            const double distance = (moved - foot).norm();
            sum += distance * distance;
            fit.residual = std::max(fit.residual, distance);
        }
        if (!(sum < 0.9999 * before) || step == 59) break;
        before = sum;
        fit.move = best_similarity(points, feet, with_scale);
    }
    return fit;
}

Similarity match_outlines(const Points3& from, const Points3& to) {
    const Outline a = measure_outline(from), b = measure_outline(to);
    Similarity match;
    match.scale = b.spread / a.spread;
    match.shift = b.centre - match.scale * a.centre;
    return match;
}

}  // namespace ripstop
