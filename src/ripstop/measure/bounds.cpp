#include "ripstop/measure/bounds.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <queue>

#include "ripstop/mesh/adjacency.h"
#include "ripstop/mesh/geodesic.h"

namespace ripstop {
namespace {

constexpr int rays = 360;

/// A half-edge that leaves the vertex farthest from the boundary along edges.
int deepest_half_edge(const Tile& tile, const Adjacency& adjacency) {
    using Reached = std::pair<double, int>;
    std::vector<double> depth(static_cast<std::size_t>(tile.mesh.vertex_count()),
                              std::numeric_limits<double>::infinity());
    std::priority_queue<Reached, std::vector<Reached>, std::greater<>> front;
    for (const int v : tile.boundary) {
        depth[static_cast<std::size_t>(v)] = 0;
        front.emplace(0.0, v);
    }
    int deepest = tile.boundary.front();
    while (!front.empty()) {
        const auto [distance, v] = front.top();
        front.pop();
        if (distance > depth[static_cast<std::size_t>(v)]) continue;
        deepest = v;
        for (const int h : adjacency.outgoing(v))
            for (const int w : {adjacency.to(h), adjacency.opposite(h)}) {
                const double there = distance + (tile.mesh.positions.row(w) - tile.mesh.positions.row(v)).norm();
                if (there >= depth[static_cast<std::size_t>(w)]) continue;
                depth[static_cast<std::size_t>(w)] = there;
                front.emplace(there, w);
            }
    }
    return adjacency.outgoing(deepest).front();
}

Vec2 ray(int i) {
    const double angle = 2 * std::numbers::pi * i / rays;
    return {std::cos(angle), std::sin(angle)};
}

}  // namespace

Bounds measure_bounds(const Tile& tile) {
    Bounds bounds;
    const double perimeter = edge_lengths(tile.mesh.positions, closed(tile.boundary)).sum();
    bounds.isoperimetric = perimeter * perimeter / (4 * std::numbers::pi * surface_area(tile.mesh));

    const UnfoldedSurface surface(tile.mesh);
    const int half_edge = deepest_half_edge(tile, Adjacency(tile.mesh.triangles, tile.mesh.vertex_count()));
    // beside the vertex, not on it: round a vertex the directions of a triangle do not go all the way
    const SurfacePoint centre = surface.at(half_edge / 3, Vec3::Constant(0.02) + 0.94 * Vec3::Unit(half_edge % 3));
    bounds.centre = surface.position(centre);
    double radius = perimeter;
    for (int i = 0; i < rays; ++i) radius = std::min(radius, surface.walk(centre, ray(i), radius).walked);
    bounds.radius = 0.999 * radius;
    double length = 0;
    Vec3 last = surface.position(surface.walk(centre, ray(rays - 1), bounds.radius).end);
    for (int i = 0; i < rays; ++i) {
        const Vec3 here = surface.position(surface.walk(centre, ray(i), bounds.radius).end);
        length += (here - last).norm();
        last = here;
    }
    // chords are shorter than arcs; counted longer than the arcs of a circle, so that the bound stays one
    length *= 1 + std::pow(2 * std::numbers::pi / rays, 2) / 16;
    bounds.stretch_ratio = std::max(1.0, 2 * std::numbers::pi * bounds.radius / length);
    return bounds;
}

double allowed_stretch_ratio(const Tolerances& tolerances) {
    const double sine = std::sin(std::min(tolerances.shear, 0.5 * std::numbers::pi));
    return (1 + tolerances.strain) / (1 - tolerances.strain) * std::sqrt((1 + sine) / (1 - sine));
}

}  // namespace ripstop
