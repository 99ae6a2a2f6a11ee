#include "ripstop/flatten/map/tutte.h"

#include <cmath>
#include <numbers>

#include "ripstop/base/index.h"
#include "ripstop/flatten/tools/barycentric.h"
#include "ripstop/flatten/tools/finish.h"
#include "ripstop/geometry/triangle.h"
#include "ripstop/mesh/adjacency.h"
#include "ripstop/mesh/boundary.h"
#include "ripstop/mesh/change/flips.h"

namespace ripstop {
namespace {

/// The boundary on the unit circle and all other vertices at its centre.
Points2 boundary_on_circle(const Tile& tile) {
    const Eigen::VectorXd lengths = edge_lengths(tile.mesh.positions, closed(tile.boundary));
    const double turn = 2 * std::numbers::pi / lengths.sum();
    Points2 positions = Points2::Zero(tile.mesh.vertex_count(), 2);
    double travelled = 0;
    for (std::size_t i = 0; i < tile.boundary.size(); ++i) {
        positions.row(tile.boundary[i]) << std::cos(turn * travelled), std::sin(turn * travelled);
        travelled += lengths[static_cast<Eigen::Index>(i)];
    }
    return positions;
}

/// The contribution of one corner to its two edges: tan of half its angle over the edge's length. Both ends of an
/// edge contribute.
double mean_value_weight(const TriangleMesh& mesh, int half_edge) {
    const int t = half_edge / 3, k = half_edge % 3;
    const Vec3 a = mesh.corner(t, k), b = mesh.corner(t, (k + 1) % 3), c = mesh.corner(t, (k + 2) % 3);
    return (std::tan(0.5 * angle_at(a, b, c)) + std::tan(0.5 * angle_at(b, c, a))) / (b - a).norm();
}

/// One positive weight per edge, in the order of `Adjacency::edges`.
Eigen::VectorXd mean_value_weights(const TriangleMesh& mesh, const Adjacency& adjacency) {
    Eigen::VectorXd weights(static_cast<Eigen::Index>(adjacency.edges().size()));
    for (Eigen::Index e = 0; e < weights.size(); ++e) {
        const int h = adjacency.edges()[at(e)];
        weights[e] = mean_value_weight(mesh, h);
        if (!adjacency.is_boundary(h)) weights[e] += mean_value_weight(mesh, adjacency.twin(h));
    }
    return weights;
}

}  // namespace

Flattening flatten_tutte(const Tile& tile) {
    const Adjacency adjacency(tile.mesh.triangles, tile.mesh.vertex_count());
    Flattening flat;
    flat.positions = boundary_on_circle(tile);
    flat.summary.iterations = 1;
    Eigen::VectorXd weights = mean_value_weights(tile.mesh, adjacency);
    bool solved = place_inside(adjacency, tile.boundary, weights, flat.positions);
    flat.summary.factorizations = tile.mesh.vertex_count() > static_cast<int>(tile.boundary.size()) ? 1 : 0;
    if (!solved || count_flipped(tile.mesh.triangles, flat.positions) > 0) {
        weights.setOnes();
        solved = place_inside(adjacency, tile.boundary, weights, flat.positions);
        ++flat.summary.factorizations;
    }
    if (!solved) {
        flat.summary.reason = "the barycentric system is singular";
        return flat;
    }
    scale_to_area(tile.mesh, flat.positions);
    finish(tile, flat, Termination::converged, "boundary on a circle, inner vertices in balance");
    return flat;
}

}  // namespace ripstop
