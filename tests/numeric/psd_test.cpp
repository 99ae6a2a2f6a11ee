#include "ripstop/numeric/psd.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <random>

namespace ripstop {
namespace psd_test {

Eigen::Matrix4d random_symmetric(unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    const Eigen::Matrix4d m = Eigen::Matrix4d::NullaryExpr([&] { return normal(random); });
    return m + m.transpose();
}

TEST(PositiveSemidefinite, LeavesADefiniteMatrixAsItIs) {
    const Eigen::Matrix4d m = random_symmetric(1);
    const Eigen::Matrix4d definite = m * m + 0.1 * Eigen::Matrix4d::Identity();
    EXPECT_EQ(positive_semidefinite(definite), definite);
}

TEST(PositiveSemidefinite, LeavesASingularOneToo) {
    const Eigen::Matrix<double, 4, 3> factor = random_symmetric(2).leftCols<3>();
    const Eigen::Matrix4d singular = factor * factor.transpose();
    EXPECT_LT((positive_semidefinite(singular) - singular).norm(), 1e-14 * singular.norm());
}

TEST(PositiveSemidefinite, ClampsTheEigenvaluesAndNothingElse) {
    for (unsigned seed = 0; seed < 200; ++seed) {
        const Eigen::Matrix4d m = random_symmetric(seed);
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> before(m);
        const Eigen::Matrix4d expected =
            before.eigenvectors() * before.eigenvalues().cwiseMax(0).asDiagonal() * before.eigenvectors().transpose();
        EXPECT_LT((positive_semidefinite(m) - expected).norm(), 1e-12 * m.norm()) << seed;
    }
}

TEST(PositiveSemidefinite, ClampsALoneNegativeEigenvalueAtEveryScale) {
    // Stiff threads, weak shear and a small negative mode in arbitrary directions, as in a triangle's Hessian.
    for (unsigned seed = 0; seed < 200; ++seed)
        for (const double negative : {-1e-9, -1e-3, -0.5, -40.0}) {
            const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> axes(random_symmetric(seed));
            const Eigen::Vector4d values(negative, 0.002, 0.7, 1);
            const auto with = [&](const Eigen::Vector4d& d) -> Eigen::Matrix4d {
                return axes.eigenvectors() * d.asDiagonal() * axes.eigenvectors().transpose();
            };
            const Eigen::Matrix4d projected = positive_semidefinite(with(values));
            const double size = std::max(1.0, -negative);
            EXPECT_LT((projected - with(values.cwiseMax(0))).norm(), 1e-12 * size) << seed << ' ' << negative;
        }
}

TEST(PositiveSemidefinite, TurnsANegativeMatrixToZero) {
    EXPECT_LT(positive_semidefinite(-2 * Eigen::Matrix4d::Identity()).norm(), 1e-15);
}

}  // namespace psd_test
}  // namespace ripstop
