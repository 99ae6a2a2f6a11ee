#include "ripstop/flatten/weave/weave_frame.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>

#include "ripstop/geometry/triangle.h"
#include "ripstop/mesh/boundary.h"
#include "ripstop/tile/targets.h"

namespace ripstop {
namespace {

/// The yarn spacing: `relative` mean edges (half a mean edge in the paper), but at least three yarns across a narrow
/// tile and about 100 crossings on one of few triangles, and at most 20 per triangle if tiny edges reduce the mean.
double yarn_spacing(const Tile& tile, const Adjacency& adjacency, double relative) {
    double sum = 0;
    for (const int h : adjacency.edges())
        sum += (tile.mesh.positions.row(adjacency.from(h)) - tile.mesh.positions.row(adjacency.to(h))).norm();
    const double mean = sum / static_cast<double>(adjacency.edges().size());
    const double area = surface_area(tile.mesh);
    const double width = 2 * area / edge_lengths(tile.mesh.positions, closed(tile.boundary)).sum();
    return std::clamp(std::min(relative * mean, width / 3), std::sqrt(area / (100 + 20.0 * tile.mesh.triangle_count())),
                      std::sqrt(area / 100));
}

/// The length of the shortest edge path from each vertex to the boundary (#V).
Eigen::VectorXd depth(const Tile& tile, const Adjacency& adjacency) {
    Eigen::VectorXd way = Eigen::VectorXd::Constant(tile.mesh.vertex_count(), std::numeric_limits<double>::infinity());
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    for (const int v : tile.boundary) {
        way[v] = 0;
        open.emplace(0.0, v);
    }
    const auto reach = [&](int v, double length) {
        if (length >= way[v]) return;
        way[v] = length;
        open.emplace(length, v);
    };
    while (!open.empty()) {
        const auto [length, v] = open.top();
        open.pop();
        if (length > way[v]) continue;
        for (const int h : adjacency.outgoing(v))
            for (const int w : {adjacency.to(h), adjacency.opposite(h)})
                reach(w, length + (tile.mesh.positions.row(v) - tile.mesh.positions.row(w)).norm());
    }
    return way;
}

double distance_to_boundary(const Tile& tile, const Vec3& point) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < tile.boundary.size(); ++i) {
        const Vec3 a = tile.mesh.positions.row(tile.boundary[i]);
        const Vec3 b = tile.mesh.positions.row(tile.boundary[(i + 1) % tile.boundary.size()]);
        const double along = std::clamp((point - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
        nearest = std::min(nearest, (point - a - along * (b - a)).norm());
    }
    return nearest;
}

/// The centre of the weave: the point of the tile nearest its area centroid. If that is close to the boundary, the
/// middle of a triangle that is far from the boundary but near the centroid. It lies slightly off edges and vertices,
/// so that the yarns of a regular mesh do not hit vertices, where rounding would choose the side.
SurfacePoint weave_centre(const Tile& tile, const Adjacency& adjacency, const UnfoldedSurface& surface) {
    const Vec3 centre = centroid(tile.mesh);
    const Eigen::VectorXd deep = depth(tile, adjacency);
    SurfacePoint best = surface.nearest(centre);
    if (distance_to_boundary(tile, surface.position(best)) < 0.25 * deep.maxCoeff()) {
        double best_score = -std::numeric_limits<double>::infinity();
        for (int t = 0; t < tile.mesh.triangle_count(); ++t) {
            const SurfacePoint middle = surface.at(t, Vec3::Constant(1.0 / 3));
            const auto corners = tile.mesh.triangles.row(t);
            const double score = (deep[corners[0]] + deep[corners[1]] + deep[corners[2]]) / 3 -
                                 0.25 * (surface.position(middle) - centre).norm();
            // rounding must not decide between equal scores
            if (score <= best_score + 1e-9 * deep.maxCoeff()) continue;
            best_score = score;
            best = middle;
        }
    }
    best.local += 0.01 * (surface.at(best.triangle, Vec3::Constant(1.0 / 3)).local - best.local);
    return best;
}

/// The warp at a point: the area-weighted mean over the unfolded triangles visible within `radius`, so that a crease
/// at the point does not rotate the whole weave.
Vec2 warp_at(const Tile& tile, const UnfoldedSurface& surface, const SurfacePoint& point, double radius) {
    const Eigen::Matrix2Xd warp = warp_in_triangles(tile);
    Vec2 sum = Vec2::Zero();
    for (const Sight& sight : surface.look_around(point, radius))
        sum += triangle_area(tile.mesh, sight.triangle) * sight.unfolded.turned(warp.col(sight.triangle));
    if (sum.norm() > 1e-9 * radius * radius) return sum.normalized();
    return warp.col(point.triangle).norm() > 0 ? Vec2(warp.col(point.triangle)) : Vec2(Vec2::UnitX());
}

}  // namespace

WeaveFrame make_weave_frame(const Tile& tile, const Adjacency& adjacency, const UnfoldedSurface& surface,
                            double relative_spacing) {
    WeaveFrame frame;
    frame.centre = weave_centre(tile, adjacency, surface);
    frame.spacing = yarn_spacing(tile, adjacency, relative_spacing);
    frame.warp = warp_at(tile, surface, frame.centre, 4 * frame.spacing);
    return frame;
}

int most_crossings(const Tile& tile) {
    return 1000 + 60 * tile.mesh.triangle_count();
}

}  // namespace ripstop
