#include "ripstop/pipeline/flight/smooth_displacement.h"

#include <Eigen/LU>
#include <Eigen/SparseCholesky>
#include <algorithm>

#include "ripstop/geometry/triangle.h"
#include "ripstop/inflate/sew.h"

namespace ripstop {
namespace {

/// Interpolation from the nodes of the sewn envelope to the vertices of every tile.
Eigen::SparseMatrix<double> shares(const SewnEnvelope& sewn) {
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t v = 0; v < sewn.places.size(); ++v)
        for (const NodeShare& part : sewn.places[v].shares)
            entries.emplace_back(static_cast<int>(v), part.node, part.weight);
    Eigen::SparseMatrix<double> matrix(static_cast<Eigen::Index>(sewn.places.size()), sewn.nodes.rows());
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

}  // namespace

std::vector<Points3> smooth_displacement(const CutPlan& plan, const Rigging& rigging,
                                         const std::vector<Points3>& displacement, double length) {
    SewOptions whole;
    whole.rigging = rigging;
    whole.symmetry = no_symmetry(plan);
    const SewnEnvelope sewn = sew(plan, whole);
    const Eigen::SparseMatrix<double> nodes_to_vertices = shares(sewn);
    const Eigen::Index count = nodes_to_vertices.rows();
    Points3 given(count, 3);
    Eigen::VectorXd areas = Eigen::VectorXd::Zero(count);
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t i = 0; i < plan.tiles.size(); ++i) {
        const TriangleMesh& mesh = plan.tiles[i].tile.mesh;
        const int first = sewn.first_vertex[i];
        given.middleRows(first, mesh.vertex_count()) = displacement[i];
        for (int t = 0; t < mesh.triangle_count(); ++t) {
            const Mat22 edges = lay_flat(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2));
            const Eigen::Matrix3d gradient = cotangent_matrix(edges);
            for (int a = 0; a < 3; ++a) {
                areas[first + mesh.triangles(t, a)] += 0.5 * std::abs(edges.determinant()) / 3;
                for (int b = 0; b < 3; ++b)
                    entries.emplace_back(first + mesh.triangles(t, a), first + mesh.triangles(t, b),
                                         length * length * gradient(a, b));
            }
        }
    }
    for (Eigen::Index v = 0; v < count; ++v) entries.emplace_back(v, v, areas[v]);
    Eigen::SparseMatrix<double> on_vertices(count, count);
    on_vertices.setFromTriplets(entries.begin(), entries.end());
    Eigen::SparseMatrix<double> on_nodes = nodes_to_vertices.transpose() * on_vertices * nodes_to_vertices;
    // Nodes without cloth, such as those of wires, stay.
    for (Eigen::Index n = 0; n < on_nodes.rows(); ++n)
        if (on_nodes.coeff(n, n) == 0) on_nodes.coeffRef(n, n) = 1;
    const Points3 wanted = nodes_to_vertices.transpose() * (areas.asDiagonal() * given);
    const Points3 smooth =
        nodes_to_vertices * Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(on_nodes).solve(wanted);
    std::vector<Points3> result;
    for (std::size_t i = 0; i < plan.tiles.size(); ++i)
        result.push_back(smooth.middleRows(sewn.first_vertex[i], displacement[i].rows()));
    return result;
}

}  // namespace ripstop
