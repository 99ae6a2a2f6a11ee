#include "ripstop/flatten/weave/weave_reading.h"

#include <Eigen/LU>
#include <algorithm>

#include "ripstop/base/index.h"
#include "ripstop/flatten/tools/grain.h"
#include "ripstop/flatten/tools/laying.h"
#include "ripstop/mesh/change/flips.h"

namespace ripstop {
namespace {

/// Transfers the plane coordinates of the crossings to the vertices. Each crossing extends its coordinates over the
/// region it sees by the affine map that takes its neighbours to their grid places; a vertex takes the mean with
/// weights (1 / distance - 1 / reach)^2.
class ReadOff {
  public:
    ReadOff(const TriangleMesh& mesh, const UnfoldedSurface& surface, const WovenFit& fit);

    Points2 positions;
    std::vector<bool> placed;

  private:
    Mat22 frame_of(const WovenNode& node, const std::vector<Sight>& sights) const;

    const WovenFit& fit_;
    std::vector<std::vector<int>> nodes_in_;
};

/// Least squares over the neighbours' (ray, grid offset), regularized towards the best rotation.
Mat22 ReadOff::frame_of(const WovenNode& node, const std::vector<Sight>& sights) const {
    Mat22 rays = Mat22::Zero();
    Mat22 both = Mat22::Zero();
    for (const Sight& sight : sights)
        for (const int n : nodes_in_[at(sight.triangle)]) {
            const WovenNode& other = fit_.nodes[at(n)];
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
    constexpr double hold = 1e-3;  // regularization, relative to a neighbour's weight
    return (both + hold * rotation) * (rays + hold * Mat22::Identity()).inverse();
}

ReadOff::ReadOff(const TriangleMesh& mesh, const UnfoldedSurface& surface, const WovenFit& fit)
    : positions(Points2::Zero(mesh.vertex_count(), 2)),
      placed(static_cast<std::size_t>(mesh.vertex_count()), false),
      fit_(fit),
      nodes_in_(static_cast<std::size_t>(mesh.triangle_count())) {
    for (std::size_t n = 0; n < fit.nodes.size(); ++n)
        if (fit.nodes[n].placed) nodes_in_[at(fit.nodes[n].at.triangle)].push_back(static_cast<int>(n));
    const double reach = woven_reach * fit.spacing;
    Eigen::VectorXd weights = Eigen::VectorXd::Zero(mesh.vertex_count());
    for (const WovenNode& node : fit.nodes) {
        if (!node.placed) continue;
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
        placed[at(v)] = true;
    }
}

}  // namespace

int count_crossings(const WovenFit& fit) {
    return static_cast<int>(
        std::count_if(fit.nodes.begin(), fit.nodes.end(), [](const WovenNode& n) { return n.placed; }));
}

std::string weave_ending(const WovenFit& fit) {
    return std::to_string(count_crossings(fit)) + " crossings of the weave " +
           (fit.at_rest ? "at rest" : "not at rest at the limit");
}

Flattening read_weave(const Tile& tile, const Adjacency& adjacency, const UnfoldedSurface& surface, const WovenFit& fit,
                      int seed, Termination termination, const std::string& reason) {
    ReadOff read(tile.mesh, surface, fit);
    constexpr int handful = 9;
    if (count_crossings(fit) < handful) std::fill(read.placed.begin(), read.placed.end(), false);
    const int laid = lay_on_missing(tile.mesh, seed, read.placed, read.positions);
    const int flipped = count_flipped(tile.mesh.triangles, read.positions);
    const int left = flipped ? repair_flipped_triangles(tile.mesh, adjacency, 50, read.positions) : 0;
    align_with_grain(tile, read.positions);

    Flattening flat;
    flat.summary.iterations = fit.iterations;
    if (!read.positions.allFinite()) {
        flat.summary.reason = "the weave gave no finite positions";
        return flat;
    }
    flat.positions = std::move(read.positions);
    flat.summary.termination = termination;
    flat.summary.reason = reason;
    if (laid > 0) flat.summary.reason += ", " + std::to_string(laid) + " vertices placed from their neighbours";
    if (flipped > 0)
        flat.summary.reason += ", " + std::to_string(flipped) + " flipped triangles of which " + std::to_string(left) +
                               " remain after repair";
    return flat;
}

}  // namespace ripstop
