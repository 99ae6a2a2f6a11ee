#include "ripstop/flatten/map/wirewarping.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "ripstop/base/error.h"
#include "ripstop/base/index.h"
#include "ripstop/flatten/tools/barycentric.h"
#include "ripstop/flatten/tools/finish.h"
#include "ripstop/mesh/boundary.h"
#include "ripstop/tile/targets.h"

namespace ripstop {
namespace {

using Vector = Eigen::VectorXd;

/// A wire that may be open, and the Jacobian of the three closing conditions with respect to its turnings.
struct Wire {
    Wire(const Vector& lengths, const Vector& turning);

    Points2 line;
    Vec3 gap;                ///< total turning minus 2 pi [rad], then the position of its end [wire lengths]
    Eigen::Matrix3Xd slope;  ///< 3 x #B
};

Wire::Wire(const Vector& lengths, const Vector& turning) : line(lengths.size(), 2), slope(3, lengths.size()) {
    const Eigen::Index n = lengths.size();
    Eigen::Matrix2Xd edge(2, n);
    Vec2 at = Vec2::Zero();
    double angle = 0;
    for (Eigen::Index i = 0; i < n; ++i) {
        if (i > 0) angle += turning[i];  // the turning at the first vertex belongs to the closing
        line.row(i) = at.transpose();
        edge.col(i) = lengths[i] / lengths.sum() * Vec2(std::cos(angle), std::sin(angle));
        at += lengths.sum() * edge.col(i);
    }
    gap << turning.sum() - 2 * std::numbers::pi, at / lengths.sum();
    Vec2 rest = Vec2::Zero();  // the part of the wire that a turning rotates about its vertex
    for (Eigen::Index i = n - 1; i >= 0; --i) {
        rest += edge.col(i);
        slope.col(i) << 1, (i > 0 ? Vec2(-rest.y(), rest.x()) : Vec2(Vec2::Zero()));
    }
}

/// The minimum-norm change of the turnings that removes `gap` to first order.
Vector least_change(const Wire& wire, const Vec3& gap) {
    const Eigen::Matrix3d normal = wire.slope * wire.slope.transpose();
    return -wire.slope.transpose() * normal.fullPivLu().solve(gap);
}

constexpr double closing = 1e-11;
constexpr double still = 1e-10;  ///< root mean square change of the turnings [rad]

}  // namespace

ClosedWire warp_wire(const Vector& lengths, const Vector& wanted, const WireWarpingOptions& options) {
    if (lengths.size() < 3 || wanted.size() != lengths.size() || options.max_iterations <= 0)
        throw InputError("wirewarping: the wire has " + std::to_string(lengths.size()) + " edges and " +
                         std::to_string(wanted.size()) +
                         " turnings, expected at least 3 and equal numbers; max_iterations > 0");
    const double root = std::sqrt(static_cast<double>(lengths.size()));
    ClosedWire best;
    best.turning = wanted;
    bool at_rest = false;
    for (const bool minimum_norm : {false, true}) {
        if (at_rest) break;
        best.turning = wanted;
        best.minimum_norm = minimum_norm;
        for (int step = 0; step < options.max_iterations && !at_rest; ++step, ++best.iterations) {
            const Wire wire(lengths, best.turning);
            const Vector away = wanted - best.turning;
            Vector change = minimum_norm ? least_change(wire, wire.gap)
                                         : Vector(away + least_change(wire, wire.gap + wire.slope * away));
            // beyond a quarter turn at a vertex the linearization predicts nothing
            change *= std::min(1.0, 0.25 * std::numbers::pi / std::max(change.lpNorm<Eigen::Infinity>(), 1e-300));
            best.turning += change;
            at_rest = change.norm() < still * root;
        }
    }
    const Wire wire(lengths, best.turning);
    best.line = wire.line;
    best.closed = wire.gap.tail<2>().norm() < closing && std::abs(wire.gap[0]) < closing * root;
    return best;
}

Flattening flatten_wirewarping(const Tile& tile, const WireWarpingOptions& options) {
    const ClosedWire wire = warp_wire(target_lengths(tile), surface_turning(tile.mesh, tile.boundary), options);
    Flattening flat;
    flat.positions = Points2::Zero(tile.mesh.vertex_count(), 2);
    flat.positions(tile.boundary, Eigen::all) = wire.line;
    flat.summary.iterations = wire.iterations;
    const Adjacency adjacency(tile.mesh.triangles, tile.mesh.vertex_count());
    Vector weights(static_cast<Eigen::Index>(adjacency.edges().size()));
    for (Eigen::Index e = 0; e < weights.size(); ++e) {
        const int h = adjacency.edges()[at(e)];
        weights[e] = 1 / (tile.mesh.positions.row(adjacency.from(h)) - tile.mesh.positions.row(adjacency.to(h))).norm();
    }
    flat.summary.factorizations = 1;
    if (!place_inside(adjacency, tile.boundary, weights, flat.positions)) {
        flat.summary.reason = "the system of the inner vertices is singular";
        return flat;
    }
    if (!wire.closed)
        finish(tile, flat, Termination::iteration_limit, "the outline does not close");
    else if (wire.minimum_norm)
        finish(tile, flat, Termination::stagnated,
               "the outline closes; its turnings are near the surface's but not the nearest");
    else
        finish(tile, flat, Termination::converged, "the outline closes with the turnings nearest to the surface's");
    return flat;
}

}  // namespace ripstop
