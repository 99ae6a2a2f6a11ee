#include "ripstop/measure/measure_bounds.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <queue>

#include "ripstop/base/index.h"
#include "ripstop/geometry/triangle.h"
#include "ripstop/mesh/adjacency.h"
#include "ripstop/mesh/geodesic.h"
#include "ripstop/tile/targets.h"

namespace ripstop {
namespace {

constexpr int rays = 360;

/// A half-edge that leaves the vertex with the longest edge path to the boundary.
int deepest_half_edge(const Tile& tile, const Adjacency& adjacency) {
    using Reached = std::pair<double, int>;
    std::vector<double> depth(static_cast<std::size_t>(tile.mesh.vertex_count()),
                              std::numeric_limits<double>::infinity());
    std::priority_queue<Reached, std::vector<Reached>, std::greater<>> front;
    for (const int v : tile.boundary) {
        depth[at(v)] = 0;
        front.emplace(0.0, v);
    }
    int deepest = tile.boundary.front();
    while (!front.empty()) {
        const auto [distance, v] = front.top();
        front.pop();
        if (distance > depth[at(v)]) continue;
        deepest = v;
        for (const int h : adjacency.outgoing(v))
            for (const int w : {adjacency.to(h), adjacency.opposite(h)}) {
                const double there = distance + (tile.mesh.positions.row(w) - tile.mesh.positions.row(v)).norm();
                if (there >= depth[at(w)]) continue;
                depth[at(w)] = there;
                front.emplace(there, w);
            }
    }
    return adjacency.outgoing(deepest).front();
}

Vec2 ray(int i) {
    const double angle = 2 * std::numbers::pi * i / rays;
    return {std::cos(angle), std::sin(angle)};
}

/// The straight distance on the surface between the ends of two consecutive rays. Empty if the ends do not see each
/// other or the rays have crossed, because then they are not shortest paths from the centre.
std::optional<double> apart(const UnfoldedSurface& surface, const Walk& one, const Walk& next, double flat_distance) {
    std::optional<double> nearest;
    for (const Sight& sight : surface.look_around(one.end, 4 * flat_distance)) {
        if (sight.triangle != next.end.triangle) continue;
        const Vec2 there = sight.unfolded(next.end.local);
        const Vec2 way = there - one.end.local;
        if (sight.hidden_by(there) > 1e-9 || (nearest && way.norm() >= *nearest)) continue;
        if (cross(one.direction, way) < -0.1 * flat_distance) return std::nullopt;
        nearest = way.norm();
    }
    return nearest;
}

/// The perimeter of the geodesic disc of the given radius, measured along the surface from ray to ray; empty if
/// undefined.
std::optional<double> edge_of_disc(const UnfoldedSurface& surface, const SurfacePoint& centre, double radius) {
    std::vector<Walk> walks;
    for (int i = 0; i < rays; ++i) walks.push_back(surface.walk(centre, ray(i), radius));
    const double flat_distance = 2 * radius * std::sin(std::numbers::pi / rays);
    double length = 0;
    for (std::size_t i = 0; i < walks.size(); ++i) {
        const auto distance = apart(surface, walks[i], walks[(i + 1) % walks.size()], flat_distance);
        if (!distance) return std::nullopt;
        length += *distance;
    }
    return length;
}

}  // namespace

Bounds measure_bounds(const Tile& tile) {
    Bounds bounds;
    const double perimeter = target_lengths(tile).sum();
    double area = 0;
    for (const Mat22& target : target_triangles(tile)) area += 0.5 * target.determinant();
    bounds.isoperimetric = perimeter * perimeter / (4 * std::numbers::pi * area);

    const UnfoldedSurface surface(tile.mesh);
    const int half_edge = deepest_half_edge(tile, Adjacency(tile.mesh.triangles, tile.mesh.vertex_count()));
    // beside the vertex: at the vertex a triangle covers only part of the directions
    const SurfacePoint centre = surface.at(half_edge / 3, Vec3::Constant(0.02) + 0.94 * Vec3::Unit(half_edge % 3));
    bounds.centre = surface.position(centre);
    double radius = perimeter;
    for (int i = 0; i < rays; ++i) radius = std::min(radius, surface.walk(centre, ray(i), radius).walked);
    bounds.radius = 0.999 * radius;
    if (tile.compensation.warp != tile.compensation.weft || tile.compensation.strain.rows() > 0)
        return bounds;  // no bound if the cloth is stretched on purpose
    // the polygon through the ray ends comes slightly closer to the centre than they do
    const double reach = bounds.radius * std::cos(std::numbers::pi / rays);
    if (const auto length = edge_of_disc(surface, centre, bounds.radius))
        bounds.stretch_ratio = std::max(1.0, 2 * std::numbers::pi * reach / *length);
    return bounds;
}

double allowed_stretch_ratio(const Tolerances& tolerances) {
    const double sine = std::sin(std::min(tolerances.shear, 0.5 * std::numbers::pi));
    return (1 + tolerances.strain) / (1 - tolerances.strain) * std::sqrt((1 + sine) / (1 - sine));
}

}  // namespace ripstop
