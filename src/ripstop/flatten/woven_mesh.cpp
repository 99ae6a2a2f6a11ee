#include "ripstop/flatten/woven_mesh.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>

#include "ripstop/base/error.h"
#include "ripstop/base/number_text.h"
#include "ripstop/flatten/grain.h"
#include "ripstop/flatten/laying.h"
#include "ripstop/flatten/woven_fit.h"
#include "ripstop/geometry/triangle.h"
#include "ripstop/mesh/flips.h"

namespace ripstop {
namespace {

void require_valid(const WovenOptions& options) {
    const auto positive = [](double value, const char* what) {
        if (!(value > 0) || !std::isfinite(value))
            throw InputError(std::string("woven mesh: ") + what + " is " + format_fixed(value, 6) +
                             "; it must be positive and finite");
    };
    positive(options.spacing, "the spacing");
    positive(options.warp_stiffness, "the warp stiffness");
    positive(options.weft_stiffness, "the weft stiffness");
    positive(options.diagonal_stiffness, "the diagonal stiffness");
    positive(options.energy_tolerance, "the energy tolerance");
    if (options.max_iterations < 0)
        throw InputError("woven mesh: the number of iterations is negative; give 0 or more");
}

/// Half the mean edge, as the paper has it, but three yarns across a narrow tile, some 100 crossings on one of few triangles
/// and no more than 20 a triangle where tiny edges draw the mean down.
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

/// Length of the shortest way along edges from each vertex to the boundary (#V).
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

/// The point of the tile nearest its area centre; where that is close to the boundary, the middle of the triangle that is
/// far from the boundary and yet not far from there. A little off every edge and vertex, so that the yarns of a regular
/// mesh do not run into vertices, where rounding would choose their side.
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
            if (score <= best_score + 1e-9 * deep.maxCoeff()) continue;  // rounding must not choose among equals
            best_score = score;
            best = middle;
        }
    }
    best.local += 0.01 * (surface.at(best.triangle, Vec3::Constant(1.0 / 3)).local - best.local);
    return best;
}

/// The warp at a point: the mean over the triangles seen from there within `radius`, each unfolded, by area, so that a
/// crease at the point does not turn the whole weave.
Vec2 warp_at(const Tile& tile, const UnfoldedSurface& surface, const SurfacePoint& point, double radius) {
    const Eigen::Matrix2Xd warp = warp_in_triangles(tile);
    Vec2 sum = Vec2::Zero();
    for (const Sight& sight : surface.look_around(point, radius))
        sum += triangle_area(tile.mesh, sight.triangle) * sight.unfolded.turned(warp.col(sight.triangle));
    if (sum.norm() > 1e-9 * radius * radius) return sum.normalized();
    return warp.col(point.triangle).norm() > 0 ? Vec2(warp.col(point.triangle)) : Vec2(Vec2::UnitX());
}

/// The crossings' plane coordinates carried to the vertices: each crossing spreads its own over what it sees, by the affine
/// map that takes its neighbours to theirs; a vertex takes the mean, weighted (1 / distance - 1 / reach)^2.
class ReadOff {
  public:
    ReadOff(const TriangleMesh& mesh, const UnfoldedSurface& surface, const WovenFit& fit);

    Points2 positions;
    std::vector<bool> placed;
    int crossings = 0;

  private:
    Mat22 frame_of(const WovenNode& node, const std::vector<Sight>& sights) const;

    const WovenFit& fit_;
    std::vector<std::vector<int>> nodes_in_;
};

/// Least squares over the neighbours' (ray, grid offset), held to the best rotation where they leave it open.
Mat22 ReadOff::frame_of(const WovenNode& node, const std::vector<Sight>& sights) const {
    Mat22 rays = Mat22::Zero();
    Mat22 both = Mat22::Zero();
    for (const Sight& sight : sights)
        for (const int n : nodes_in_[static_cast<std::size_t>(sight.triangle)]) {
            const WovenNode& other = fit_.nodes[static_cast<std::size_t>(n)];
            const Vec2 offset(other.warp - node.warp, other.weft - node.weft);
            const Vec2 point = sight.unfolded(other.at.local);
            if (offset.lpNorm<Eigen::Infinity>() > 1 || sight.hidden_by(point) > 0) continue;
            const Vec2 ray = (point - node.at.local) / fit_.spacing;
            rays += ray * ray.transpose();
            both += offset * ray.transpose();
        }
    Vec2 turn(both(0, 0) + both(1, 1), both(1, 0) - both(0, 1));
    turn = turn.norm() > 0 ? Vec2(turn.normalized()) : Vec2(Vec2::UnitX());
    Mat22 rotation;
    rotation << turn.x(), -turn.y(), turn.y(), turn.x();
    constexpr double hold = 1e-3;  // of a neighbour's weight
    return (both + hold * rotation) * (rays + hold * Mat22::Identity()).inverse();
}

ReadOff::ReadOff(const TriangleMesh& mesh, const UnfoldedSurface& surface, const WovenFit& fit)
    : positions(Points2::Zero(mesh.vertex_count(), 2)),
      placed(static_cast<std::size_t>(mesh.vertex_count()), false),
      fit_(fit),
      nodes_in_(static_cast<std::size_t>(mesh.triangle_count())) {
    for (std::size_t n = 0; n < fit.nodes.size(); ++n)
        if (fit.nodes[n].placed)
            nodes_in_[static_cast<std::size_t>(fit.nodes[n].at.triangle)].push_back(static_cast<int>(n));
    const double reach = woven_reach * fit.spacing;
    Eigen::VectorXd weights = Eigen::VectorXd::Zero(mesh.vertex_count());
    for (const WovenNode& node : fit.nodes) {
        if (!node.placed) continue;
        ++crossings;
        const std::vector<Sight> sights = surface.look_around(node.at, reach);
        const Mat22 frame = frame_of(node, sights);
        for (const Sight& sight : sights)
            for (int k = 0; k < 3; ++k) {
                if (sight.corner >= 0 && k != sight.corner) continue;
                const Vec2 point = sight.unfolded(surface.corner(sight.triangle, k));
                const double distance = (point - node.at.local).norm();
                if (distance >= reach || sight.hidden_by(point) > 0) continue;
                const double closeness = (reach - distance) / (reach * (distance + 1e-3 * fit.spacing));
                const int v = mesh.triangles(sight.triangle, k);
                const Vec2 grid = fit.spacing * Vec2(node.warp, node.weft) + frame * (point - node.at.local);
                positions.row(v) += closeness * closeness * grid.transpose();
                weights[v] += closeness * closeness;
            }
    }
    for (int v = 0; v < mesh.vertex_count(); ++v) {
        if (weights[v] == 0) continue;
        positions.row(v) /= weights[v];
        placed[static_cast<std::size_t>(v)] = true;
    }
}

}  // namespace

Flattening flatten_woven(const Tile& tile, const Fabric& /*fabric*/, const WovenOptions& options) {
    require_valid(options);
    const Adjacency adjacency(tile.mesh.triangles, tile.mesh.vertex_count());
    const UnfoldedSurface surface(tile.mesh);
    const SurfacePoint centre = weave_centre(tile, adjacency, surface);
    const double spacing = yarn_spacing(tile, adjacency, options.spacing);
    const Vec2 warp = warp_at(tile, surface, centre, 4 * spacing);
    const int max_nodes = 1000 + 60 * tile.mesh.triangle_count();
    const WovenFit fit = fit_woven_mesh(surface, centre, warp, spacing, max_nodes, options);

    ReadOff read(tile.mesh, surface, fit);
    constexpr int handful = 9;
    if (read.crossings < handful) std::fill(read.placed.begin(), read.placed.end(), false);
    const int laid = lay_on_missing(tile.mesh, centre.triangle, read.placed, read.positions);
    const int flipped = count_flipped(tile.mesh.triangles, read.positions);
    const int left = flipped ? repair_flipped_triangles(tile.mesh, adjacency, 50, read.positions) : 0;
    align_with_grain(tile, read.positions);

    Flattening flat;
    flat.summary.iterations = fit.iterations;
    if (!read.positions.allFinite()) {
        flat.summary.reason = "the woven mesh gave no finite positions";
        return flat;
    }
    flat.positions = std::move(read.positions);
    flat.summary.termination = fit.at_rest ? Termination::converged : Termination::iteration_limit;
    flat.summary.reason = std::to_string(read.crossings) + " crossings of the weave " +
                          (fit.at_rest ? "at rest" : "not at rest at the limit");
    if (laid > 0) flat.summary.reason += ", " + std::to_string(laid) + " vertices laid on from their neighbours";
    if (flipped > 0)
        flat.summary.reason += ", " + std::to_string(flipped) + " flipped triangles of which " + std::to_string(left) +
                               " remain after repair";
    return flat;
}

}  // namespace ripstop
