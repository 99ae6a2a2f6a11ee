#include "ripstop/flatten/seam/seam_problem.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "ripstop/flatten/seam/seam_newton.h"
#include "ripstop/tile/make_tile.h"
#include "support/fabrics.h"
#include "support/finite_difference.h"
#include "support/shapes.h"

namespace ripstop {
namespace seam_problem_test {

using Vector = Eigen::VectorXd;

struct Case {
    Tile tile = make_tile("t", testing::spherical_square(0.5, 3), {.warp = Vec3(1, 0.3, 0)});
    SeamProblem problem{tile, testing::uneven_cloth(20), {.bending = 0.01, .keep_area = true}};
    Vector u, lambda, mu;

    Case() {
        std::mt19937 random(9);
        std::uniform_real_distribution<double> jitter(-0.02, 0.02);
        Points2 flat = tile.mesh.positions.leftCols(2);
        u = Eigen::Map<Vector>(flat.data(), flat.size());
        u = u.unaryExpr([&](double x) { return x + jitter(random); });
        lambda = Vector::NullaryExpr(problem.edge_count(), [&](Eigen::Index) { return 1000 * jitter(random); });
        mu = Vector::NullaryExpr(2, [&](Eigen::Index) { return 1000 * jitter(random); });
    }
};

Eigen::MatrixXd dense(const SeamProblem& problem, const Vector& values) {
    Eigen::MatrixXd matrix(problem.unknowns(), problem.unknowns());
    for (int i = 0; i < problem.unknowns(); ++i)
        matrix.col(i) = product(problem.pattern(), values, Vector::Unit(problem.unknowns(), i));
    return matrix;
}

TEST(SeamProblem, GradientIsThatOfTheEnergy) {
    const Case c;
    const auto energy = [&](const Vector& u) { return Vector::Constant(1, c.problem.energy(u)).eval(); };
    const Vector measured = testing::jacobian(energy, c.u).transpose();
    EXPECT_LT((measured - c.problem.gradient(c.u)).norm(), 1e-6 * measured.norm());
}

TEST(SeamProblem, AssembledHessianIsThatOfTheLagrangianWithItsWeight) {
    const Case c;
    const double rho = 300;
    const auto gradient = [&](const Vector& u) {
        // the gradient of energy + lambda · length + mu · dense + rho/2 |length - length at c.u|^2; that last term
        // is Gauss-Newton only
        const Vector apart = c.problem.edge_residual(u) - c.problem.edge_residual(c.u);
        return Vector(c.problem.gradient(u) + c.problem.edge_transposed(u, c.lambda + rho * apart) +
                      c.problem.dense_rows(u) * c.mu);
    };
    Vector g, values;
    c.problem.assemble(c.u, c.lambda, c.mu, rho, Curvature::exact, g, values);
    const Eigen::MatrixXd measured = testing::jacobian(gradient, c.u);
    EXPECT_LT((measured - dense(c.problem, values)).norm(), 1e-6 * measured.norm());
    EXPECT_LT((g - c.problem.gradient(c.u)).norm(), 1e-12 * g.norm());
}

TEST(SeamProblem, ConstraintDerivativesByFiniteDifferences) {
    const Case c;
    const Eigen::MatrixXd edges = testing::jacobian([&](const Vector& u) { return c.problem.edge_residual(u); }, c.u);
    const Vector d = Vector::LinSpaced(c.problem.unknowns(), -1, 2);
    EXPECT_LT((edges * d - c.problem.edge_product(c.u, d)).norm(), 1e-6 * d.norm());
    EXPECT_LT((edges.transpose() * c.lambda - c.problem.edge_transposed(c.u, c.lambda)).norm(), 1e-6 * c.lambda.norm());
    const Eigen::MatrixXd rows = testing::jacobian([&](const Vector& u) { return c.problem.dense_residual(u); }, c.u);
    EXPECT_LT((rows.transpose() - c.problem.dense_rows(c.u)).norm(), 1e-6);
}

TEST(SeamProblem, LongestStepStopsBeforeTheFirstTriangleWithoutArea) {
    const Case c;
    Vector d = Vector::Zero(c.problem.unknowns());
    const int inner = 5;  // an inner vertex of the 4 x 4 grid, moved far to the right
    d[2 * inner] = 10;
    const double step = c.problem.longest_step(c.u, d);
    EXPECT_LT(step, 1);
    EXPECT_TRUE(std::isfinite(c.problem.energy(c.u + step * d)));
    EXPECT_FALSE(std::isfinite(c.problem.energy(c.u + step / 0.9 * 1.0001 * d)));
}

TEST(SeamNewton, SatisfiesTheFirstOrderConditionsAfterAFewFactorizations) {
    const Tile tile = make_tile("t", testing::spherical_square(0.4, 8), {.warp = Vec3::UnitX()});
    const SeamProblem problem(tile, Fabric{}, {});
    Points2 flat = tile.mesh.positions.leftCols(2);
    const Vector start = Eigen::Map<Vector>(flat.data(), flat.size());
    SeamNewton newton(problem);
    const SeamSolution at = newton.minimize(start);
    ASSERT_EQ(at.summary.termination, Termination::converged);
    EXPECT_TRUE(at.strict_minimum);
    const Vector balance =
        problem.gradient(at.u) + problem.edge_transposed(at.u, at.lambda) + problem.dense_rows(at.u) * at.mu;
    EXPECT_LT(balance.lpNorm<Eigen::Infinity>(), 1e-6);
    EXPECT_LT(problem.edge_residual(at.u).lpNorm<Eigen::Infinity>(), 1e-12);
    EXPECT_LE(at.summary.factorizations, 3);
}

TEST(SeamNewton, MultipliersArePricesOfTheLengths) {
    // dE/dl = -lambda, the sensitivity of a constrained minimum
    const Tile tile = make_tile("t", testing::spherical_square(0.4, 4), {.warp = Vec3::UnitX()});
    SeamProblem problem(tile, Fabric{}, {});
    Points2 flat = tile.mesh.positions.leftCols(2);
    SeamNewton newton(problem);
    const SeamSolution at = newton.minimize(Eigen::Map<Vector>(flat.data(), flat.size()));
    const Vector lengths = problem.lengths();
    for (const int edge : {0, 3, 7}) {
        const double step = 1e-5 * lengths[edge];
        const auto energy = [&](double change) {
            Vector changed = lengths;
            changed[edge] += change;
            problem.set_lengths(changed);
            return newton.minimize(at.u).energy;
        };
        const double slope = (energy(step) - energy(-step)) / (2 * step);
        EXPECT_NEAR(slope, -at.lambda[edge], 1e-4 * at.lambda.lpNorm<Eigen::Infinity>());
    }
}

TEST(SeamNewton, RefusesAStartThatIsTurnedOver) {
    const Tile tile = make_tile("t", testing::spherical_square(0.4, 3), {.warp = Vec3::UnitX()});
    const SeamProblem problem(tile, Fabric{}, {});
    Points2 flat = tile.mesh.positions.leftCols(2) * Eigen::Vector2d(-1, 1).asDiagonal();
    SeamNewton newton(problem);
    EXPECT_EQ(newton.minimize(Eigen::Map<Vector>(flat.data(), flat.size())).summary.termination, Termination::failed);
}

}  // namespace seam_problem_test
}  // namespace ripstop
