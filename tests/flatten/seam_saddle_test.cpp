#include "ripstop/flatten/seam/seam_saddle.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include "ripstop/flatten/map/boundary_first.h"
#include "ripstop/tile/make_tile.h"
#include "support/fabrics.h"
#include "support/shapes.h"

namespace ripstop {
namespace seam_saddle_test {

using Vector = Eigen::VectorXd;

/// A flat square of 2 n x 2 n cells, symmetric about both midlines, whose edges must become longer than drawn. The
/// cloth is pulled in both directions and prefers to become a rhombus, of which there are two.
Tile square_with_long_edges(int n, double longer) {
    TriangleMesh mesh = testing::grid(2 * n, 2 * n, [](double u, double v) { return Vec3(u, v, 0); });
    const int row = 2 * n + 1;
    int t = 0;
    for (int j = 0; j < 2 * n; ++j)
        for (int i = 0; i < 2 * n; ++i) {
            const int a = j * row + i, b = a + 1, c = b + row, d = c - 1;
            const bool rising = (i < n) == (j < n);
            mesh.triangles.row(t++) << a, b, rising ? c : d;
            mesh.triangles.row(t++) << (rising ? a : b), c, d;
        }
    TileOptions options;
    options.warp = Vec3::UnitX();
    options.compensation.chains = {longer, longer, longer, longer};
    return make_tile("square", mesh, options);
}

/// The point where Newton's method stops when it starts from the symmetric shape.
SeamSolution symmetric_rest(const Tile& tile, SeamNewton& newton) {
    const Points2 start = flatten_boundary_first(tile).positions;
    return newton.minimize(Eigen::Map<const Vector>(start.data(), start.size()));
}

/// The smallest curvature of the energy in the directions that edges and grain leave free, in E. Computed with
/// dense algebra, independently of the solver.
double least_curvature(const SeamProblem& problem, const SeamSolution& at) {
    Vector gradient, values;
    problem.assemble(at.u, at.lambda, at.mu, 0, Curvature::exact, gradient, values);
    const int size = problem.unknowns(), edges = problem.edge_count();
    Eigen::MatrixXd hessian(size, size), held = Eigen::MatrixXd::Zero(size, edges + 3);
    for (int i = 0; i < size; ++i) hessian.col(i) = product(problem.pattern(), values, Vector::Unit(size, i));
    for (int e = 0; e < edges; ++e) held.col(e) = problem.edge_transposed(at.u, Vector::Unit(edges, e));
    held.col(edges) = problem.dense_rows(at.u).col(0);
    for (int i = 0; i < size; ++i) held(i, edges + 1 + i % 2) = 1;
    const Eigen::MatrixXd q = Eigen::HouseholderQR<Eigen::MatrixXd>(held).householderQ();
    const Eigen::MatrixXd free = q.rightCols(size - edges - 3);
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(free.transpose() * hessian * free).eigenvalues()[0] /
           problem.stiffness();
}

TEST(SeamSaddle, IsNoMinimumAndIsLeft) {
    const Tile tile = square_with_long_edges(2, 0.02);
    const SeamProblem problem(tile, testing::cloth(0, 0.002), {.bending = 1e-5});
    SeamNewton newton(problem);
    const SeamSolution saddle = symmetric_rest(tile, newton);
    ASSERT_EQ(saddle.summary.termination, Termination::converged);
    EXPECT_LT(least_curvature(problem, saddle), -1e-6);
    EXPECT_FALSE(saddle.strict_minimum);
    const SeamSolution rest = leave_saddles(problem, newton, saddle);
    EXPECT_EQ(rest.summary.termination, Termination::converged);
    EXPECT_TRUE(rest.strict_minimum);
    EXPECT_GT(least_curvature(problem, rest), 0);
    EXPECT_LT(rest.energy, 0.99 * saddle.energy);
    EXPECT_LT(rest.length_residual, 1e-10);
}

TEST(SeamSaddle, IsNeverCertifiedAndMinimaAre) {
    int minima = 0, certified = 0, saddles = 0;
    for (const int n : {1, 2})
        for (const double shear : {0.5, 0.05, 0.01, 0.002})
            for (const double longer : {-0.05, 0.0, 0.02, 0.05, 0.1}) {
                SCOPED_TRACE(std::to_string(n) + " " + std::to_string(shear) + " " + std::to_string(longer));
                const Tile tile = square_with_long_edges(n, longer);
                const SeamProblem problem(tile, testing::cloth(0, shear), {.bending = 1e-5});
                SeamNewton newton(problem);
                const SeamSolution rest = symmetric_rest(tile, newton);
                if (rest.summary.termination != Termination::converged) continue;
                const double least = least_curvature(problem, rest);
                EXPECT_TRUE(least > 0 || !rest.strict_minimum) << least;
                ++(least > 0 ? minima : saddles);
                certified += rest.strict_minimum;
            }
    EXPECT_GT(certified, minima / 2);  // pivots need not certify cloth that would rotate and shear at once
    EXPECT_GT(minima, 10);
    EXPECT_GT(saddles, 3);
}

TEST(SeamSaddle, LeavesAMinimumAsItIs) {
    const Tile tile = square_with_long_edges(2, 0.02);
    const SeamProblem problem(tile, testing::cloth(0, 0.5), {.bending = 1e-5});
    SeamNewton newton(problem);
    const SeamSolution rest = symmetric_rest(tile, newton);
    ASSERT_TRUE(rest.strict_minimum);
    EXPECT_EQ(leave_saddles(problem, newton, rest).u, rest.u);
}

}  // namespace seam_saddle_test
}  // namespace ripstop
