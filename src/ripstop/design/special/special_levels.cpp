#include "ripstop/design/special/special_levels.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace ripstop {
namespace {

using std::numbers::pi;

/// The direction away from the axis; any direction on the axis itself.
Vec3 outward(const Vec3& x) {
    const double r = std::hypot(x.x(), x.y());
    return r > 0 ? Vec3(x.x() / r, x.y() / r, 0) : Vec3(1, 0, 0);
}

Level ellipsoid_level(const Vec3& radii, const Vec3& x) {
    const Vec3 q = x.cwiseQuotient(radii.cwiseAbs2());
    const double k = x.cwiseQuotient(radii).norm();
    const double steep = q.norm();
    if (!(steep > 1e-9 / radii.maxCoeff())) return {-radii.minCoeff(), Vec3::UnitX()};
    const Vec3 grown = q.cwiseQuotient(radii.cwiseAbs2());
    return {k * (k - 1) / steep, (2 - 1 / k) * q / steep - k * (k - 1) / (steep * steep * steep) * grown};
}

Level torus_level(const SpecialPrimitive& p, const Vec3& x) {
    const Vec3 from_middle = x - p.radius * outward(x);
    const double distance = from_middle.norm();
    return {distance - p.tube_radius, distance > 0 ? Vec3(from_middle / distance) : Vec3::UnitZ()};
}

Level capsule_level(const SpecialPrimitive& p, const Vec3& x) {
    const Vec3 from_segment = x - Vec3(0, 0, std::clamp(x.z(), -p.length / 2, p.length / 2));
    const double distance = from_segment.norm();
    return {distance - p.radius, distance > 0 ? Vec3(from_segment / distance) : Vec3::UnitX()};
}

Level cone_side_level(const SpecialPrimitive& p, const Vec3& x) {
    const double slope = (p.radius - p.top_radius) / p.length;
    const double scale = 1 / std::hypot(1, slope);
    const double out = std::hypot(x.x(), x.y()) - p.radius + slope * x.z();
    return {scale * out, scale * (outward(x) + slope * Vec3::UnitZ())};
}

/// Heights that divide the half ellipse with radii `across` and `along` into equal arc lengths, from the lower end.
std::vector<double> ellipse_heights(double across, double along, int rings) {
    constexpr int samples = 4096;
    std::vector<double> length{0};
    for (int i = 0; i < samples; ++i) {
        const double t = pi * (i + 0.5) / samples;
        length.push_back(length.back() + std::hypot(across * std::cos(t), along * std::sin(t)) * pi / samples);
    }
    std::vector<double> heights;
    std::size_t below = 0;
    for (int k = 1; k < rings; ++k) {
        const double wanted = length.back() * k / rings;
        while (length[below + 1] < wanted) ++below;
        const double part = (wanted - length[below]) / (length[below + 1] - length[below]);
        heights.push_back(-along * std::cos(pi * (static_cast<double>(below) + part) / samples));
    }
    return heights;
}

double capsule_height(const SpecialPrimitive& p, double along) {
    const double quarter = pi / 2 * p.radius;
    if (along < quarter) return -p.length / 2 - p.radius * std::cos(along / p.radius);
    if (along > quarter + p.length) return p.length / 2 + p.radius * std::sin((along - quarter - p.length) / p.radius);
    return along - quarter - p.length / 2;
}

}  // namespace

Level part_level(const SpecialPrimitive& p, int part, const Vec3& x) {
    if (part == 1) return {-x.z(), -Vec3::UnitZ()};
    if (part == 2) return {x.z() - p.length, Vec3::UnitZ()};
    switch (p.kind) {
        case PrimitiveKind::ellipsoid:
            return ellipsoid_level(p.radii, x);
        case PrimitiveKind::torus:
            return torus_level(p, x);
        case PrimitiveKind::capsule:
            return capsule_level(p, x);
        case PrimitiveKind::cone:
            break;
    }
    return cone_side_level(p, x);
}

std::vector<double> ring_heights(const SpecialPrimitive& p) {
    std::vector<double> heights;
    switch (p.kind) {
        case PrimitiveKind::ellipsoid:
            return ellipse_heights((p.radii.x() + p.radii.y()) / 2, p.radii.z(), p.rings);
        case PrimitiveKind::torus:
            break;
        case PrimitiveKind::capsule:
            for (int k = 1; k < p.rings; ++k)
                heights.push_back(capsule_height(p, (pi * p.radius + p.length) * k / p.rings));
            break;
        case PrimitiveKind::cone:
            for (int k = 1; k < p.rings; ++k) heights.push_back(p.length * k / p.rings);
            break;
    }
    return heights;
}

std::pair<Vec3, Vec3> middle_and_reach(const SpecialPrimitive& p, const Eigen::Matrix3d& frame) {
    const Vec3 axis = frame.row(2);
    // half extent of a unit circle across the axis
    const Vec3 across = (Vec3::Ones() - axis.cwiseAbs2()).cwiseMax(0).cwiseSqrt();
    switch (p.kind) {
        case PrimitiveKind::ellipsoid:
            return {p.centre, (p.radii.asDiagonal() * frame).colwise().norm().transpose()};
        case PrimitiveKind::torus:
            return {p.centre, p.radius * across + Vec3::Constant(p.tube_radius)};
        case PrimitiveKind::capsule:
            return {p.centre, p.length / 2 * axis.cwiseAbs() + Vec3::Constant(p.radius)};
        case PrimitiveKind::cone:
            break;
    }
    return {p.centre + p.length / 2 * axis, p.length / 2 * axis.cwiseAbs() + std::max(p.radius, p.top_radius) * across};
}

LevelBall ball_round(const SpecialPrimitive& p, const Eigen::Matrix3d& frame) {
    switch (p.kind) {
        case PrimitiveKind::ellipsoid:
            return {p.centre, p.radii.maxCoeff(), p.radii.minCoeff() / p.radii.maxCoeff()};
        case PrimitiveKind::torus:
            return {p.centre, p.radius + p.tube_radius, 1};
        case PrimitiveKind::capsule:
            return {p.centre, p.length / 2 + p.radius, 1};
        case PrimitiveKind::cone:
            break;
    }
    return {p.centre + p.length / 2 * Vec3(frame.row(2)), std::hypot(p.length / 2, std::max(p.radius, p.top_radius)),
            0};
}

Eigen::Matrix3d own_frame(const SpecialPrimitive& p) {
    const Vec3 z = p.axis.stableNormalized();
    const Vec3 towards = std::abs(z.x()) < 0.999 ? Vec3::UnitX() : Vec3::UnitY();
    const Vec3 x = (towards - towards.dot(z) * z).normalized();
    const Vec3 y = z.cross(x);
    Eigen::Matrix3d frame;
    frame.row(0) = std::cos(p.turn) * x + std::sin(p.turn) * y;
    frame.row(1) = z.cross(Vec3(frame.row(0)));
    frame.row(2) = z;
    return frame;
}

}  // namespace ripstop
