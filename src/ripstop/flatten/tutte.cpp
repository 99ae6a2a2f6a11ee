#include "ripstop/flatten/tutte.h"

#include <array>
#include <cmath>
#include <numbers>

#include "ripstop/flatten/finish.h"
#include "ripstop/geometry/triangle.h"
#include "ripstop/mesh/adjacency.h"
#include "ripstop/mesh/flips.h"
#include "ripstop/numeric/symmetric_solver.h"

namespace ripstop {
namespace {

/// The boundary on the unit circle, everything else at its centre.
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

/// What one corner adds to its two edges: tan of half its angle over the edge's length. Both ends of an edge add.
double mean_value_weight(const TriangleMesh& mesh, int half_edge) {
    const int t = half_edge / 3, k = half_edge % 3;
    const Vec3 a = mesh.corner(t, k), b = mesh.corner(t, (k + 1) % 3), c = mesh.corner(t, (k + 2) % 3);
    return (std::tan(0.5 * angle_at(a, b, c)) + std::tan(0.5 * angle_at(b, c, a))) / (b - a).norm();
}

/// One weight an edge, in the order of `Adjacency::edges`; positive.
Eigen::VectorXd mean_value_weights(const TriangleMesh& mesh, const Adjacency& adjacency) {
    Eigen::VectorXd weights(static_cast<Eigen::Index>(adjacency.edges().size()));
    for (Eigen::Index e = 0; e < weights.size(); ++e) {
        const int h = adjacency.edges()[static_cast<std::size_t>(e)];
        weights[e] = mean_value_weight(mesh, h);
        if (!adjacency.is_boundary(h)) weights[e] += mean_value_weight(mesh, adjacency.twin(h));
    }
    return weights;
}

/// Every inner vertex in the weighted mean of its neighbours. False where the system could not be solved.
bool relax(const Adjacency& adjacency, const std::vector<int>& unknown, int size, const Eigen::VectorXd& weights,
           Flattening& flat) {
    Couplings couplings;
    std::vector<std::array<int, 3>> inner;  // the unknowns of an edge, -1 at the boundary, and its number
    for (std::size_t e = 0; e < adjacency.edges().size(); ++e) {
        const int h = adjacency.edges()[e];
        const int a = unknown[static_cast<std::size_t>(adjacency.from(h))];
        const int b = unknown[static_cast<std::size_t>(adjacency.to(h))];
        if (a < 0 && b < 0) continue;
        if (a < 0 || b < 0)
            couplings.add_element(std::array{std::max(a, b)});
        else
            couplings.add_element(std::array{a, b});
        inner.push_back({a, b, static_cast<int>(e)});
    }
    const SparsePattern pattern(size, couplings);
    Eigen::VectorXd values = Eigen::VectorXd::Zero(pattern.entry_count());
    Eigen::MatrixXd right = Eigen::MatrixXd::Zero(size, 2);
    for (std::size_t g = 0; g < inner.size(); ++g) {
        const auto [a, b, e] = inner[g];
        const auto slots = pattern.slots(static_cast<int>(g));
        const int h = adjacency.edges()[static_cast<std::size_t>(e)];
        for (const int slot : slots) values[slot] += weights[e];
        if (a >= 0 && b >= 0)
            values[slots[1]] -= 2 * weights[e];
        else
            right.row(std::max(a, b)) += weights[e] * flat.positions.row(a < 0 ? adjacency.from(h) : adjacency.to(h));
    }
    SymmetricSolver solver(pattern);
    const bool solved = solver.factorize(values);
    ++flat.summary.factorizations;
    if (!solved) return false;
    const Eigen::MatrixXd x = solver.solve_columns(right);
    for (std::size_t v = 0; v < unknown.size(); ++v)
        if (unknown[v] >= 0) flat.positions.row(static_cast<Eigen::Index>(v)) = x.row(unknown[v]);
    return true;
}

}  // namespace

Flattening flatten_tutte(const Tile& tile) {
    const Adjacency adjacency(tile.mesh.triangles, tile.mesh.vertex_count());
    std::vector<int> unknown(static_cast<std::size_t>(tile.mesh.vertex_count()), 0);
    for (const int v : tile.boundary) unknown[static_cast<std::size_t>(v)] = -1;
    int size = 0;
    for (int& u : unknown)
        if (u == 0) u = size++;

    Flattening flat;
    flat.positions = boundary_on_circle(tile);
    flat.summary.iterations = 1;
    if (size > 0) {
        Eigen::VectorXd weights = mean_value_weights(tile.mesh, adjacency);
        bool solved = relax(adjacency, unknown, size, weights, flat);
        if (!solved || count_flipped(tile.mesh.triangles, flat.positions) > 0) {
            weights.setOnes();
            solved = relax(adjacency, unknown, size, weights, flat);
        }
        if (!solved) {
            flat.summary.reason = "the barycentric system is singular";
            return flat;
        }
    }
    scale_to_area(tile.mesh, flat.positions);
    finish(tile, flat, Termination::converged, "boundary on a circle, inner vertices in balance");
    return flat;
}

}  // namespace ripstop
