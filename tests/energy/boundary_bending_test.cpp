#include "ripstop/energy/boundary_bending.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>
#include <random>

#include "support/finite_difference.h"

namespace ripstop {
namespace boundary_bending_test {

using Vector6 = Eigen::Matrix<double, 6, 1>;

BendingElement at(const Vector6& x, bool semidefinite = false) {
    return boundary_bending(x.segment<2>(0), x.segment<2>(2), x.segment<2>(4), 0.3, 2.5, 0.7, semidefinite);
}

std::vector<Vector6> some_bends() {
    std::mt19937 random(4);
    std::uniform_real_distribution<double> uniform(-1, 1);
    std::vector<Vector6> bends;
    for (int i = 0; i < 10; ++i) {
        Vector6 x;
        x << -1, 0, 0, 0, 1, 0;
        bends.push_back(x + 0.6 * Vector6::NullaryExpr([&](Eigen::Index) { return uniform(random); }));
    }
    return bends;
}

TEST(BoundaryBending, KnowsNothingOfPoseOrScale) {
    for (const Vector6& x : some_bends()) {
        const double before = at(x).energy;
        Vector6 moved;
        for (int i = 0; i < 3; ++i) moved.segment<2>(2 * i) = 3 * Vec2(-x[2 * i + 1], x[2 * i]) + Vec2(5, -2);
        EXPECT_NEAR(at(moved).energy, before, 1e-12);
    }
}

TEST(BoundaryBending, QuarterTurnByHand) {
    const BendingElement bend = boundary_bending({0, 0}, {1, 0}, {1, 2}, 0, 4, 0.5, false);
    EXPECT_DOUBLE_EQ(turning({0, 0}, {1, 0}, {1, 2}), std::numbers::pi / 2);
    EXPECT_DOUBLE_EQ(bend.energy, 0.5 * 4 / 0.5 * std::pow(std::numbers::pi / 2, 2));
}

TEST(BoundaryBending, GradientByFiniteDifferences) {
    for (const Vector6& x : some_bends()) {
        const auto energy = [](const Eigen::VectorXd& y) { return Eigen::VectorXd::Constant(1, at(y).energy).eval(); };
        const Eigen::VectorXd measured = testing::jacobian(energy, x).transpose();
        EXPECT_LT((measured - at(x).gradient).norm(), 1e-6 * (1 + measured.norm()));
    }
}

TEST(BoundaryBending, HessianByFiniteDifferences) {
    for (const Vector6& x : some_bends()) {
        const auto gradient = [](const Eigen::VectorXd& y) { return Eigen::VectorXd(at(y).gradient); };
        const Eigen::MatrixXd measured = testing::jacobian(gradient, x);
        EXPECT_LT((measured - at(x).hessian).norm(), 1e-6 * (1 + measured.norm()));
    }
}

TEST(BoundaryBending, ItsSemidefiniteHessianHasNoNegativeEigenvalue) {
    for (const Vector6& x : some_bends()) {
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> solver(at(x, true).hessian);
        EXPECT_GT(solver.eigenvalues().minCoeff(), -1e-12 * solver.eigenvalues().maxCoeff());
    }
}

}  // namespace boundary_bending_test
}  // namespace ripstop
