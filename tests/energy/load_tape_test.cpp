#include "ripstop/energy/load_tape.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <random>

#include "support/finite_difference.h"

namespace ripstop {
namespace load_tape_test {

constexpr double stiffness = 80e3;

Vec3 end(const Eigen::VectorXd& x, int k) {
    return x.segment<3>(3 * k);
}

TEST(LoadTape, GradientAndHessianAreTheDerivatives) {
    std::mt19937 random(2);
    std::normal_distribution<double> normal;
    for (int k = 0; k < 50; ++k) {
        const Eigen::VectorXd x = Eigen::VectorXd::NullaryExpr(6, [&] { return normal(random); });
        const double rest = 0.99 * (end(x, 1) - end(x, 0)).norm();
        const auto energy = [&](const Eigen::VectorXd& at) {
            return Eigen::VectorXd::Constant(1, tape_energy(stiffness, rest, end(at, 0), end(at, 1))).eval();
        };
        const auto gradient = [&](const Eigen::VectorXd& at) -> Eigen::VectorXd {
            return tape_element(stiffness, rest, end(at, 0), end(at, 1)).gradient;
        };
        const TapeElement element = tape_element(stiffness, rest, end(x, 0), end(x, 1));
        EXPECT_EQ(element.energy, energy(x)[0]);
        EXPECT_LT((testing::jacobian(energy, x, 1e-6).transpose() - element.gradient).norm(), 1e-4);
        EXPECT_LT((testing::jacobian(gradient, x, 1e-6) - element.hessian).norm(), 1e-6 * element.hessian.norm());
        const auto values = Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>>(element.hessian).eigenvalues();
        EXPECT_GE(values.minCoeff(), -1e-14 * values.maxCoeff());
    }
}

TEST(LoadTape, SlackItIsNothing) {
    for (const double length : {0.0, 0.5, 0.999, 1.0}) {
        const TapeElement element = tape_element(stiffness, 1, Vec3::Zero(), Vec3(0, length, 0));
        EXPECT_EQ(element.energy, 0);
        EXPECT_TRUE(element.gradient.isZero(0));
        EXPECT_TRUE(element.hessian.isZero(0));
        EXPECT_EQ(tape_force(stiffness, 1, Vec3::Zero(), Vec3(0, length, 0)), 0);
    }
}

TEST(LoadTape, PullsByItsStiffnessTimesItsStretch) {
    // 2 m at rest, stretched by 0.5 %: e = 0.0050125, force EA e l / L = 403.005 N.
    const Vec3 a(1, 1, 1), b = a + 2.01 * Vec3(2, -1, 2) / 3;
    const double strain = 0.5 * (1.005 * 1.005 - 1);
    EXPECT_NEAR(tape_force(stiffness, 2, a, b), 80e3 * strain * 1.005, 1e-8);
    EXPECT_NEAR(tape_force(stiffness, 2, a, b), 403.005, 1e-3);
    const TapeElement element = tape_element(stiffness, 2, a, b);
    EXPECT_LT((element.gradient.tail<3>() - tape_force(stiffness, 2, a, b) * (b - a).normalized()).norm(), 1e-9);
    EXPECT_EQ(element.gradient.head<3>(), -element.gradient.tail<3>());
    EXPECT_NEAR(element.energy, 0.5 * 2 * stiffness * strain * strain, 1e-12);
}

}  // namespace load_tape_test
}  // namespace ripstop
