#include "ripstop/mesh/geodesic.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "ripstop/geometry/triangle.h"

namespace ripstop {
namespace {

Vec2 nearest_on_segment(const Vec2& p, const Vec2& a, const Vec2& b) {
    const Vec2 ab = b - a;
    return a + std::clamp((p - a).dot(ab) / ab.squaredNorm(), 0.0, 1.0) * ab;
}

/// The rigid motion that takes the edge from -> to of one triangle to its twin in the neighbour's frame, which runs
/// the other way.
PlaneMotion motion_across(const Vec2& from, const Vec2& to, const Vec2& twin_from, const Vec2& twin_to) {
    const Vec2 here = (to - from).normalized();
    const Vec2 there = (twin_from - twin_to).normalized();
    PlaneMotion motion;
    motion.turn = Vec2(here.dot(there), cross(here, there));
    motion.shift = 0.5 * (twin_from + twin_to) - motion.turned(0.5 * (from + to));
    return motion;
}

}  // namespace

double Sight::hidden_by(const Vec2& point) const {
    if (corner < 0) return 0;
    const Vec2 ray = point - eye;
    const double length = ray.norm();
    if (length == 0) return 0;
    const double right = cross(ray, between[0]) / (length * between[0].norm());
    const double left = cross(between[1], ray) / (length * between[1].norm());
    return std::max({right, left, 0.0});
}

UnfoldedSurface::UnfoldedSurface(const TriangleMesh& mesh) : frames_(static_cast<std::size_t>(mesh.triangle_count())) {
    const Adjacency adjacency(mesh.triangles, mesh.vertex_count());
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        Frame& f = frames_[static_cast<std::size_t>(t)];
        f.origin = mesh.corner(t, 0);
        const Mat22 flat = lay_flat(f.origin, mesh.corner(t, 1), mesh.corner(t, 2));
        f.corners = {Vec2(Vec2::Zero()), Vec2(flat.col(0)), Vec2(flat.col(1))};
        f.x_axis = (mesh.corner(t, 1) - f.origin).normalized();
        const Vec3 side = mesh.corner(t, 2) - f.origin;
        f.y_axis = (side - side.dot(f.x_axis) * f.x_axis).normalized();
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec2 edge = f.corners[(k + 1) % 3] - f.corners[k];
            f.outward[k] = Vec2(edge.y(), -edge.x()).normalized();
            f.offset[k] = f.outward[k].dot(f.corners[k]);
            f.twin[k] = adjacency.twin(3 * t + static_cast<int>(k));
        }
    }
    for (Frame& f : frames_)
        for (std::size_t k = 0; k < 3; ++k) {
            if (f.twin[k] < 0) continue;
            const Frame& other = frame(Adjacency::triangle(f.twin[k]));
            const auto j = static_cast<std::size_t>(f.twin[k] % 3);
            f.across[k] =
                motion_across(f.corners[k], f.corners[(k + 1) % 3], other.corners[j], other.corners[(j + 1) % 3]);
        }
}

Vec3 UnfoldedSurface::position(const SurfacePoint& point) const {
    const Frame& f = frame(point.triangle);
    return f.origin + point.local.x() * f.x_axis + point.local.y() * f.y_axis;
}

SurfacePoint UnfoldedSurface::at(int triangle, const Vec3& barycentric) const {
    const Frame& f = frame(triangle);
    return {triangle, barycentric[1] * f.corners[1] + barycentric[2] * f.corners[2]};
}

Vec3 UnfoldedSurface::barycentric(const SurfacePoint& point) const {
    const Frame& f = frame(point.triangle);
    const double c = point.local.y() / f.corners[2].y();
    const double b = (point.local.x() - c * f.corners[2].x()) / f.corners[1].x();
    return {1 - b - c, b, c};
}

Vec2 UnfoldedSurface::along(int triangle, const Vec3& direction) const {
    const Frame& f = frame(triangle);
    return {direction.dot(f.x_axis), direction.dot(f.y_axis)};
}

SurfacePoint UnfoldedSurface::nearest(const Vec3& point) const {
    SurfacePoint best;
    double best_distance = std::numeric_limits<double>::infinity();
    for (int t = 0; t < triangle_count(); ++t) {
        const Frame& f = frame(t);
        const Vec2 foot = along(t, point - f.origin);
        Vec2 local = foot;
        bool inside = true;
        for (std::size_t k = 0; k < 3; ++k) inside = inside && f.outward[k].dot(foot) <= f.offset[k];
        if (!inside) {
            double closest = std::numeric_limits<double>::infinity();
            for (std::size_t k = 0; k < 3; ++k) {
                const Vec2 on = nearest_on_segment(foot, f.corners[k], f.corners[(k + 1) % 3]);
                if ((on - foot).squaredNorm() >= closest) continue;
                closest = (on - foot).squaredNorm();
                local = on;
            }
        }
        const double distance = (position({t, local}) - point).norm();
        // rounding must not decide between equal distances
        if (distance >= best_distance - 1e-9 * f.corners[1].x()) continue;
        best_distance = distance;
        best = {t, local};
    }
    return best;
}

Walk UnfoldedSurface::walk(const SurfacePoint& from, const Vec2& direction, double length) const {
    // The walk runs along an edge if it leaves it at less than this sine: rounding must not push it off a boundary
    // edge.
    constexpr double parallel = 1e-12;
    Walk gone{from, direction.normalized()};
    const std::size_t step_limit = 64 + 16 * frames_.size();  // ends a walk that circles for ever
    std::size_t entered = 3;
    for (std::size_t step = 0; step < step_limit; ++step) {
        const Frame& f = frame(gone.end.triangle);
        std::size_t exit = 3;
        double ahead = length - gone.walked;
        for (std::size_t k = 0; k < 3; ++k) {
            const double speed = f.outward[k].dot(gone.direction);
            if (k == entered || speed <= parallel) continue;
            const double until = std::max(0.0, (f.offset[k] - f.outward[k].dot(gone.end.local)) / speed);
            if (until >= ahead) continue;
            ahead = until;
            exit = k;
        }
        gone.end.local += ahead * gone.direction;
        gone.walked += ahead;
        if (exit == 3) return gone;
        if (f.twin[exit] < 0) {
            gone.hit_boundary = true;
            return gone;
        }
        gone.end = {Adjacency::triangle(f.twin[exit]), f.across[exit](gone.end.local)};
        gone.direction = f.across[exit].turned(gone.direction).normalized();
        entered = static_cast<std::size_t>(f.twin[exit] % 3);
    }
    return gone;
}

std::vector<Sight> UnfoldedSurface::look_around(const SurfacePoint& from, double radius) const {
    std::vector<Sight> sights;
    sights.reserve(32);
    const Frame& own = frame(from.triangle);
    Sight first;
    first.triangle = from.triangle;
    // Rays from a corner or an edge along that edge have no direction, so the eye is moved slightly inside. It only
    // decides what is visible; distances are measured from the point itself.
    first.eye = from.local + 1e-6 * ((own.corners[0] + own.corners[1] + own.corners[2]) / 3 - from.local);
    sights.push_back(first);

    const auto look_through = [&](const Sight& near, std::size_t k, const Vec2& right, const Vec2& left) {
        const Frame& f = frame(near.triangle);
        if (f.twin[k] < 0 || cross(right, left) <= 0) return;
        const Vec2 a = near.unfolded(f.corners[k]);
        const Vec2 b = near.unfolded(f.corners[(k + 1) % 3]);
        if ((nearest_on_segment(from.local, a, b) - from.local).squaredNorm() > radius * radius) return;
        const Frame& other = frame(Adjacency::triangle(f.twin[k]));
        const auto j = static_cast<std::size_t>(f.twin[k] % 3);
        Sight next;
        next.triangle = Adjacency::triangle(f.twin[k]);
        next.corner = static_cast<int>((j + 2) % 3);
        next.unfolded = near.unfolded.after(other.across[j]);
        next.eye = near.eye;
        next.between = {right, left};
        sights.push_back(next);
    };
    for (std::size_t k = 0; k < 3; ++k)
        look_through(first, k, own.corners[k] - first.eye, own.corners[(k + 1) % 3] - first.eye);
    for (std::size_t seen = 1; seen < sights.size(); ++seen) {
        const Sight near = sights[seen];
        const auto apex = static_cast<std::size_t>(near.corner);
        const Vec2 ray = near.unfolded(frame(near.triangle).corners[apex]) - near.eye;
        const auto& [right, left] = near.between;
        // Edge apex + 2 ends at the apex and appears to its right; edge apex starts there and appears to its left.
        look_through(near, (apex + 2) % 3, right, cross(ray, left) > 0 ? ray : left);
        look_through(near, apex, cross(right, ray) > 0 ? ray : right, left);
    }
    return sights;
}

}  // namespace ripstop
