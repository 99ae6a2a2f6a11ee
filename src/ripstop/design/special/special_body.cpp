#include "ripstop/design/special/special_body.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include "ripstop/base/index.h"

namespace ripstop {
namespace {

using std::numbers::pi;

/// The angle modulo 2 pi, from 0 on.
double positive(double angle) {
    return angle < 0 ? angle + 2 * pi : angle;
}

double azimuth(const Vec3& own) {
    return positive(std::atan2(own.y(), own.x()));
}

/// The index of the sector that contains the mean of up to three angles. Requires that they lie within half a turn of
/// each other.
int slice(const double (&angles)[3], int known, int slices) {
    double sum = 0;
    for (int k = 0; k < known; ++k) {
        double angle = angles[k] - angles[0];
        if (angle > pi) angle -= 2 * pi;
        if (angle < -pi) angle += 2 * pi;
        sum += angle;
    }
    const double middle = positive(std::remainder(angles[0] + sum / std::max(known, 1), 2 * pi));
    return std::min(static_cast<int>(middle / (2 * pi) * slices), slices - 1);
}

/// The seam nearest to an angle, among `count` at equal angles.
int nearest_seam(double angle, int count) {
    return static_cast<int>(std::lround(angle / (2 * pi) * count)) % count;
}

}  // namespace

SpecialBody::SpecialBody(const SpecialShape& shape, double rounding) : shape_(shape), rounding_(rounding) {
    for (int p = 0; p < static_cast<int>(shape.primitives.size()); ++p) {
        const SpecialPrimitive& primitive = shape.primitives[at(p)];
        const int parts = primitive.kind != PrimitiveKind::cone ? 1 : primitive.top_radius > 0 ? 3 : 2;
        frames_.push_back(own_frame(primitive));
        ring_heights_.push_back(ring_heights(primitive));
        balls_.push_back(ball_round(primitive, frames_.back()));
        faces_of_.emplace_back();
        for (int part = 0; part < parts; ++part) {
            faces_of_.back().push_back(static_cast<int>(faces_.size()));
            faces_.push_back({p, part});
        }
    }
}

double SpecialBody::least_level(int primitive, const Vec3& x) const {
    const LevelBall& ball = balls_[at(primitive)];
    const double beyond = (x - ball.middle).norm() - ball.radius;
    return beyond > 0 ? ball.rise * beyond : -1e300;
}

Vec3 SpecialBody::local(int primitive, const Vec3& x) const {
    return frames_[at(primitive)] * (x - shape_.primitives[at(primitive)].centre);
}

double SpecialBody::tube_angle(int primitive, const Vec3& own) const {
    return positive(std::atan2(own.z(), std::hypot(own.x(), own.y()) - shape_.primitives[at(primitive)].radius));
}

Level SpecialBody::face_level(int face, const Vec3& x) const {
    const Face& f = faces_[at(face)];
    Level level = part_level(shape_.primitives[at(f.primitive)], f.part, local(f.primitive, x));
    level.gradient = frames_[at(f.primitive)].transpose() * level.gradient;
    return level;
}

int SpecialBody::face_shown(int primitive, const Vec3& x) const {
    const std::vector<int>& faces = faces_of_[at(primitive)];
    if (faces.size() == 1) return faces[0];
    int shown = faces[0];
    double highest = face_level(shown, x).value;
    for (const int face : faces)
        if (const double value = face_level(face, x).value; value > highest) {
            highest = value;
            shown = face;
        }
    return shown;
}

Level SpecialBody::solid_level(int primitive, const Vec3& x) const {
    const Level shown = face_level(face_shown(primitive, x), x);
    if (!(rounding_ > 0 && shown.value > -rounding_) || faces_of_[at(primitive)].size() == 1) return shown;
    double squares = 0;
    Vec3 gradient = Vec3::Zero();
    for (const int face : faces_of_[at(primitive)])
        if (const Level level = face_level(face, x); level.value > -rounding_) {
            squares += (level.value + rounding_) * (level.value + rounding_);
            gradient += (level.value + rounding_) * level.gradient;
        }
    return {std::sqrt(squares) - rounding_, gradient / std::sqrt(squares)};
}

Level SpecialBody::surface_level(int face, const Vec3& x) const {
    const Level own = rounding_ > 0 ? solid_level(faces_[at(face)].primitive, x) : face_level(face, x);
    const double radius = shape_.joint_radius;
    if (!(radius > 0)) return own;
    double squares = 0;
    Vec3 gradient = Vec3::Zero();
    const auto add = [&](const Level& level) {
        const double within = radius - level.value;
        if (!(within > 0)) return;
        squares += within * within;
        gradient += within * level.gradient;
    };
    add(own);
    for (int p = 0; p < static_cast<int>(faces_of_.size()); ++p)
        if (p != faces_[at(face)].primitive && least_level(p, x) < radius) add(solid_level(p, x));
    if (!(squares > 0)) return own;
    return {radius - std::sqrt(squares), gradient / std::sqrt(squares)};
}

int SpecialBody::owner(const Vec3& x) const {
    int nearest = 0;
    double least = solid_level(0, x).value;
    for (int p = 1; p < static_cast<int>(faces_of_.size()); ++p) {
        if (least_level(p, x) > least) continue;
        if (const double value = solid_level(p, x).value; value < least) {
            least = value;
            nearest = p;
        }
    }
    return face_shown(nearest, x);
}

Level SpecialBody::curve_level(const BodyCurve& curve, const Vec3& x) const {
    if (curve.kind == BodyCurve::mouth) return {x.z() - shape_.mouth.value_or(0), Vec3::UnitZ()};
    if (curve.kind == BodyCurve::crease) {
        const Level a = face_level(curve.a, x);
        const Level b = face_level(curve.b, x);
        return {a.value - b.value, a.gradient - b.gradient};
    }
    const SpecialPrimitive& p = shape_.primitives[at(curve.a)];
    const Vec3 own = local(curve.a, x);
    Level level;
    if (curve.kind == BodyCurve::sector) {
        const double angle = 2 * pi * curve.b / p.sectors;
        level.gradient = Vec3(-std::sin(angle), std::cos(angle), 0);
        level.value = level.gradient.dot(own);
    } else if (p.kind == PrimitiveKind::torus) {
        const double angle = 2 * pi * curve.b / p.rings;
        const double r = std::hypot(own.x(), own.y());
        level.value = std::cos(angle) * own.z() - std::sin(angle) * (r - p.radius);
        level.gradient = Vec3(0, 0, std::cos(angle));
        if (r > 0) level.gradient -= std::sin(angle) / r * Vec3(own.x(), own.y(), 0);
    } else {
        level = {own.z() - ring_heights_[at(curve.a)][at(curve.b - 1)], Vec3::UnitZ()};
    }
    level.gradient = frames_[at(curve.a)].transpose() * level.gradient;
    return level;
}

bool SpecialBody::reaches(const BodyCurve& curve, const Vec3& x) const {
    if (curve.kind == BodyCurve::crease || curve.kind == BodyCurve::mouth) return true;
    const SpecialPrimitive& p = shape_.primitives[at(curve.a)];
    const Vec3 own = local(curve.a, x);
    if (curve.kind == BodyCurve::sector) {
        const double angle = 2 * pi * curve.b / p.sectors;
        return std::cos(angle) * own.x() + std::sin(angle) * own.y() > 0;
    }
    if (p.kind != PrimitiveKind::torus) return true;
    const double angle = 2 * pi * curve.b / p.rings;
    return std::cos(angle) * (std::hypot(own.x(), own.y()) - p.radius) + std::sin(angle) * own.z() > 0;
}

std::vector<BodyCurve> SpecialBody::sector_curves(int primitive) const {
    const int sectors = shape_.primitives[at(primitive)].sectors;
    std::vector<BodyCurve> curves;
    for (int k = 0; k < sectors && sectors > 1; ++k) curves.push_back({BodyCurve::sector, primitive, k});
    return curves;
}

std::vector<BodyCurve> SpecialBody::ring_curves(int primitive) const {
    const SpecialPrimitive& p = shape_.primitives[at(primitive)];
    std::vector<BodyCurve> curves;
    for (int k = p.kind == PrimitiveKind::torus ? 0 : 1; k < p.rings && p.rings > 1; ++k)
        curves.push_back({BodyCurve::ring, primitive, k});
    return curves;
}

BodyCurve SpecialBody::curve_between(const BodyCell& one, const BodyCell& other, const Vec3& near) const {
    if (one.face != other.face)
        return {BodyCurve::crease, std::min(one.face, other.face), std::max(one.face, other.face)};
    if (one.below != other.below) return {BodyCurve::mouth, 0, 0};
    const int primitive = faces_[at(one.face)].primitive;
    const SpecialPrimitive& p = shape_.primitives[at(primitive)];
    const Vec3 own = local(primitive, near);
    if (one.sector != other.sector) return {BodyCurve::sector, primitive, nearest_seam(azimuth(own), p.sectors)};
    if (p.kind == PrimitiveKind::torus)
        return {BodyCurve::ring, primitive, nearest_seam(tube_angle(primitive, own), p.rings)};
    return {BodyCurve::ring, primitive, std::max(one.ring, other.ring)};
}

int SpecialBody::sector_of(int primitive, const Vec3 (&corners)[3]) const {
    double angles[3] = {0, 0, 0};
    int known = 0;
    for (const Vec3& corner : corners)
        if (const Vec3 own = local(primitive, corner); std::hypot(own.x(), own.y()) > 1e-9)
            angles[known++] = azimuth(own);
    return slice(angles, known, shape_.primitives[at(primitive)].sectors);
}

int SpecialBody::ring_of(int primitive, const Vec3 (&corners)[3]) const {
    const SpecialPrimitive& p = shape_.primitives[at(primitive)];
    if (p.kind == PrimitiveKind::torus) {
        double angles[3];
        for (int k = 0; k < 3; ++k) angles[k] = tube_angle(primitive, local(primitive, corners[k]));
        return slice(angles, 3, p.rings);
    }
    const double height = local(primitive, (corners[0] + corners[1] + corners[2]) / 3).z();
    const std::vector<double>& heights = ring_heights_[at(primitive)];
    return static_cast<int>(std::upper_bound(heights.begin(), heights.end(), height) - heights.begin());
}

std::vector<Vec3> SpecialBody::poles(int primitive) const {
    const SpecialPrimitive& p = shape_.primitives[at(primitive)];
    const Vec3 axis = frames_[at(primitive)].row(2);
    if (p.kind == PrimitiveKind::torus || (p.sectors == 1 && p.kind != PrimitiveKind::cone)) return {};
    if (p.kind == PrimitiveKind::cone) {
        std::vector<Vec3> poles;
        if (p.sectors > 1) poles.push_back(p.centre);
        if (p.sectors > 1 || !(p.top_radius > 0)) poles.push_back(p.centre + p.length * axis);
        return poles;
    }
    const double reach = p.kind == PrimitiveKind::ellipsoid ? p.radii.z() : p.length / 2 + p.radius;
    return {p.centre - reach * axis, p.centre + reach * axis};
}

std::pair<Vec3, Vec3> SpecialBody::box() const {
    Vec3 low = Vec3::Constant(1e300);
    Vec3 high = -low;
    for (std::size_t p = 0; p < frames_.size(); ++p) {
        const auto [middle, reach] = middle_and_reach(shape_.primitives[p], frames_[p]);
        low = low.cwiseMin(middle - reach);
        high = high.cwiseMax(middle + reach);
    }
    return {low - Vec3::Constant(shape_.joint_radius), high + Vec3::Constant(shape_.joint_radius)};
}

}  // namespace ripstop
