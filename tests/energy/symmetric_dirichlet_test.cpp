#include "ripstop/energy/symmetric_dirichlet.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "ripstop/geometry/triangle.h"
#include "support/finite_difference.h"

namespace ripstop {
namespace symmetric_dirichlet_test {

using Vec6 = Eigen::Matrix<double, 6, 1>;

const Mat22 rest = lay_flat(Vec3(0.3, -0.2, 1), Vec3(1.5, 0.4, 0.7), Vec3(0.5, 1.1, 0.4));

Mat22 edges(const Vec6& x) {
    Mat22 flat;
    flat << x[2] - x[0], x[4] - x[0], x[3] - x[1], x[5] - x[1];
    return flat;
}

/// The corners at rest, rotated and shifted, then each moved by a random vector of size `noise`.
Vec6 near_rest(double noise, unsigned seed) {
    const Mat22 flat = Eigen::Rotation2Dd(0.4) * rest;
    Vec6 x;
    x << 3, -1, 3 + flat(0, 0), -1 + flat(1, 0), 3 + flat(0, 1), -1 + flat(1, 1);
    std::mt19937 random(seed);
    std::normal_distribution<double> normal(0, noise);
    return x + Vec6::NullaryExpr([&] { return normal(random); });
}

TEST(SymmetricDirichlet, IsZeroAtRestUnderRigidMotion) {
    for (const double turn : {0.0, 0.4, 2.5}) {
        const Mat22 flat = Eigen::Rotation2Dd(turn) * rest;
        const MembraneElement element = symmetric_dirichlet(rest, flat);
        EXPECT_LT(element.energy, 1e-29);  // square of the rounding error
        EXPECT_LT(element.gradient.norm(), 1e-14);
    }
    const Mat22 strained = rest + Mat22::Constant(0.1);
    const double still = symmetric_dirichlet_energy(rest, strained);
    EXPECT_NEAR(symmetric_dirichlet_energy(rest, Eigen::Rotation2Dd(1) * strained), still, 1e-14 * still);
}

TEST(SymmetricDirichlet, StretchByHand) {
    // singular values 2 and 1/4: (2 - 1/2)^2 + (1/4 - 4)^2, on a right triangle of area 1/2
    Mat22 flat;
    flat << 2, 0, 0, 0.25;
    EXPECT_DOUBLE_EQ(symmetric_dirichlet_energy(Mat22::Identity(), flat), 0.5 * (2.25 + 14.0625));
    EXPECT_DOUBLE_EQ(symmetric_dirichlet(Mat22::Identity(), flat).energy, 0.5 * (2.25 + 14.0625));
    // stretching and compressing by the same factor cost the same
    EXPECT_DOUBLE_EQ(symmetric_dirichlet_energy(Mat22::Identity(), 2 * Mat22::Identity()),
                     symmetric_dirichlet_energy(Mat22::Identity(), 0.5 * Mat22::Identity()));
}

TEST(SymmetricDirichlet, GradientIsTheDerivativeOfTheEnergy) {
    for (unsigned seed = 0; seed < 20; ++seed) {
        const Vec6 x = near_rest(0.1, seed);
        const auto energy = [&](const Eigen::VectorXd& y) {
            return Eigen::VectorXd::Constant(1, symmetric_dirichlet_energy(rest, edges(y))).eval();
        };
        const Eigen::VectorXd measured = testing::jacobian(energy, x).transpose();
        EXPECT_LT((measured - symmetric_dirichlet(rest, edges(x)).gradient).norm(), 1e-7 * measured.norm()) << seed;
    }
}

TEST(SymmetricDirichlet, HessianIsTheDerivativeOfTheGradient) {
    for (unsigned seed = 0; seed < 20; ++seed) {
        const Vec6 x = near_rest(0.1, seed);
        const auto gradient = [&](const Eigen::VectorXd& y) {
            return Eigen::VectorXd(symmetric_dirichlet(rest, edges(y)).gradient);
        };
        const auto hessian = symmetric_dirichlet(rest, edges(x)).hessian;
        const Eigen::MatrixXd measured = testing::jacobian(gradient, x);
        EXPECT_LT((measured - hessian).norm(), 1e-7 * measured.norm()) << seed;
    }
}

TEST(SymmetricDirichlet, SemidefiniteHessianHasNoNegativeCurvature) {
    int indefinite = 0;
    for (unsigned seed = 0; seed < 50; ++seed) {
        const Mat22 flat = edges(near_rest(0.2, seed));
        const auto smallest = [&](Curvature curvature) {
            const auto hessian = symmetric_dirichlet(rest, flat, curvature).hessian;
            return Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>>(hessian).eigenvalues()[0] /
                   hessian.norm();
        };
        EXPECT_GT(smallest(Curvature::semidefinite), -1e-12) << seed;
        indefinite += smallest(Curvature::exact) < -1e-9;
    }
    EXPECT_GT(indefinite, 5);  // otherwise the test shows nothing
}

TEST(SymmetricDirichlet, IsInfiniteForATriangleTurnedOverAndGrowsTowardsIt) {
    double last = 0;
    for (const double height : {0.5, 0.1, 0.01, 1e-4}) {
        Mat22 squeezed = rest;
        squeezed.row(1) *= height;
        EXPECT_GT(symmetric_dirichlet_energy(rest, squeezed), 5 * last);
        last = symmetric_dirichlet_energy(rest, squeezed);
    }
    Mat22 over = rest;
    over.row(1) *= -1;
    EXPECT_EQ(symmetric_dirichlet_energy(rest, over), std::numeric_limits<double>::infinity());
    EXPECT_EQ(symmetric_dirichlet(rest, over).energy, std::numeric_limits<double>::infinity());
}

}  // namespace symmetric_dirichlet_test
}  // namespace ripstop
