#include "ripstop/energy/relaxed_membrane.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <map>
#include <random>

#include "support/finite_difference.h"
#include "support/membranes.h"

namespace ripstop {
namespace relaxed_membrane_test {

Vec3 corner(const Eigen::VectorXd& x, int k) {
    return x.segment<3>(3 * k);
}

struct Case {
    Mat22 flat;
    Eigen::VectorXd x;  ///< corners in space
};

/// Triangles of about one metre, strained by some per cent and rotated.
std::vector<Case> random_cases(int count, double noise) {
    std::mt19937 random(11);
    std::normal_distribution<double> normal;
    std::vector<Case> cases;
    while (static_cast<int>(cases.size()) < count) {
        Case each{Mat22::NullaryExpr([&] { return normal(random); }), Eigen::VectorXd::Zero(9)};
        if (each.flat.determinant() < 0.2) continue;
        const Eigen::Quaterniond turn(normal(random), normal(random), normal(random), normal(random));
        for (int k = 1; k < 3; ++k)
            each.x.segment<3>(3 * k) = turn.normalized() * Vec3(each.flat(0, k - 1), each.flat(1, k - 1), 0);
        each.x += noise * Eigen::VectorXd::NullaryExpr(9, [&] { return normal(random); });
        cases.push_back(each);
    }
    return cases;
}

SpaceElement element_of(const Case& each, const TensionField& cloth) {
    return RelaxedMembrane(each.flat).element(cloth, corner(each.x, 0), corner(each.x, 1), corner(each.x, 2));
}

TEST(RelaxedMembrane, GradientAndHessianAreTheDerivatives) {
    constexpr double step = 1e-7;
    const TensionField relaxed(testing::balloon_nylon());
    std::map<ClothState, int> count;
    for (const Case& each : random_cases(200, 0.02)) {
        const RelaxedMembrane membrane(each.flat);
        const auto energy = [&](const Eigen::VectorXd& x) {
            return Eigen::VectorXd::Constant(1, membrane.energy(relaxed, corner(x, 0), corner(x, 1), corner(x, 2)))
                .eval();
        };
        const auto gradient = [&](const Eigen::VectorXd& x) -> Eigen::VectorXd {
            return membrane.element(relaxed, corner(x, 0), corner(x, 1), corner(x, 2)).gradient;
        };
        const auto state = [&](const Eigen::VectorXd& x) {
            return relaxed.at(green_voigt(membrane.deformation(corner(x, 0), corner(x, 1), corner(x, 2)))).state;
        };
        bool is_inside = true;  // of its state; the Hessian jumps between two states
        for (int k = 0; k < 9; ++k)
            for (const double way : {-20 * step, 20 * step})
                is_inside = is_inside && state(each.x + way * Eigen::VectorXd::Unit(9, k)) == state(each.x);
        if (!is_inside) continue;
        ++count[state(each.x)];
        const SpaceElement element = element_of(each, relaxed);
        EXPECT_NEAR(element.energy, energy(each.x)[0], 1e-12 * element.energy);
        // 60 kN/m over a metre: the rounding error divided by the step, plus the step squared.
        EXPECT_LT((testing::jacobian(energy, each.x, step).transpose() - element.gradient).norm(), 1e-3);
        EXPECT_LT((testing::jacobian(gradient, each.x, step) - element.hessian).norm(),
                  1e-5 * element.hessian.norm() + 1e-2);
    }
    EXPECT_GT(count[ClothState::taut], 20);
    EXPECT_GT(count[ClothState::wrinkled], 20);
    EXPECT_GT(count[ClothState::slack], 20);
}

TEST(RelaxedMembrane, GradientIsExactWithAResidualToo) {
    const TensionField cloth(testing::balloon_nylon(), 1e-2);
    for (const Case& each : random_cases(50, 0.02)) {
        const RelaxedMembrane membrane(each.flat);
        const auto energy = [&](const Eigen::VectorXd& x) {
            return Eigen::VectorXd::Constant(1, membrane.energy(cloth, corner(x, 0), corner(x, 1), corner(x, 2)))
                .eval();
        };
        EXPECT_LT((testing::jacobian(energy, each.x, 1e-7).transpose() - element_of(each, cloth).gradient).norm(),
                  1e-3);
    }
}

TEST(RelaxedMembrane, HessianIsNeverNegative) {
    for (const double residual : {0.0, 1e-4, 1e-2})
        for (const Case& each : random_cases(400, 0.3)) {
            const TensionField cloth(testing::balloon_nylon(), residual);
            const Mat99 hessian = element_of(each, cloth).hessian;
            EXPECT_LT((hessian - hessian.transpose()).norm(), 1e-12 * hessian.norm() + 1e-300);
            const auto values = Eigen::SelfAdjointEigenSolver<Mat99>(hessian).eigenvalues();
            EXPECT_GE(values.minCoeff(), -1e-13 * values.maxCoeff());
        }
}

TEST(RelaxedMembrane, MovingTheTriangleAsAWholeChangesNothing) {
    const TensionField cloth(testing::balloon_nylon(), 1e-3);
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.1, Vec3(1, -2, 0.5).normalized()).toRotationMatrix();
    for (const Case& each : random_cases(50, 0.05)) {
        const SpaceElement element = element_of(each, cloth);
        Case moved = each;
        for (int k = 0; k < 3; ++k) moved.x.segment<3>(3 * k) = turn * corner(each.x, k) + Vec3(3, 4, -5);
        EXPECT_NEAR(element_of(moved, cloth).energy, element.energy, 1e-10 * element.energy);
        Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
        for (int k = 0; k < 3; ++k) {
            force += element.gradient.segment<3>(3 * k);
            moment += corner(each.x, k).cross(Vec3(element.gradient.segment<3>(3 * k)));
        }
        EXPECT_LT(force.norm(), 1e-12 * element.gradient.norm());
        EXPECT_LT(moment.norm(), 1e-12 * element.gradient.norm());
    }
}

TEST(RelaxedMembrane, PrincipalTensionsAreTheTrueOnesOfTheStretchedCloth) {
    // 1.1 along the warp, 1.05 along the weft: N = F S F^T / J is 1.1 / 1.05 times S11 and 1.05 / 1.1 times S22.
    Mat32 F;
    F << 1.1, 0, 0, 0, 0, 1.05;
    const Vec2 tensions = principal_tensions(F, {300, 500, 0});
    EXPECT_NEAR(tensions[0], 500 * 1.05 / 1.1, 1e-10);
    EXPECT_NEAR(tensions[1], 300 * 1.1 / 1.05, 1e-10);
}

}  // namespace relaxed_membrane_test
}  // namespace ripstop
