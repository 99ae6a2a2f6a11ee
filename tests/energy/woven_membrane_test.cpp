#include "ripstop/energy/woven_membrane.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "ripstop/base/text/units.h"
#include "ripstop/geometry/triangle.h"
#include "support/finite_difference.h"
#include "support/shapes.h"

namespace ripstop {
namespace woven_membrane_test {

using Vec6 = Eigen::Matrix<double, 6, 1>;

Fabric balloon_cloth() {
    Fabric fabric;
    fabric.warp_stiffness = 20e3;
    fabric.weft_stiffness = 14e3;
    fabric.shear_stiffness = 300;
    fabric.poisson = 0.2;
    return fabric;
}

const Vec3 a(0.3, -0.2, 1), b(1.5, 0.4, 0.7), c(0.5, 1.1, 0.4);

Mat22 edges(const Vec6& x) {
    Mat22 flat;
    flat << x[2] - x[0], x[4] - x[0], x[3] - x[1], x[5] - x[1];
    return flat;
}

/// The corners of the triangle abc laid flat, rotated and shifted, then each moved by a random vector of size
/// `noise`.
Vec6 near_rest(double noise, unsigned seed) {
    const Mat22 flat = Eigen::Rotation2Dd(0.4) * lay_flat(a, b, c);
    Vec6 x;
    x << 3, -1, 3 + flat(0, 0), -1 + flat(1, 0), 3 + flat(0, 1), -1 + flat(1, 1);
    std::mt19937 random(seed);
    std::normal_distribution<double> normal(0, noise);
    return x + Vec6::NullaryExpr([&] { return normal(random); });
}

TEST(WovenMembrane, IsZeroAtRestUnderRigidMotion) {
    const WovenMembrane membrane(balloon_cloth());
    for (const double turn : {0.0, 0.4, 2.5}) {
        const Mat22 flat = Eigen::Rotation2Dd(turn) * lay_flat(a, b, c);
        const MembraneElement element = membrane.element(triangle_metric(a, b, c), flat);
        EXPECT_LT(std::abs(element.energy), 1e-25 * 20e3);  // square of the rounding error
        EXPECT_LT(element.gradient.norm(), 1e-11);          // rounding of 20 kN/m
    }
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(1, Vec3(1, 2, 3).normalized()).toRotationMatrix();
    const Mat22 flat = 1.02 * lay_flat(a, b, c);
    const double still = membrane.energy(triangle_metric(a, b, c), flat);
    EXPECT_NEAR(membrane.energy(triangle_metric(turn * a, turn * b, turn * c), flat), still, 1e-12 * still);
}

TEST(WovenMembrane, WarpStretchByHand) {
    // A right triangle 1 x 1 on the cloth, whose warp side is 1.01 long in space.
    Fabric fabric = balloon_cloth();
    const TriangleMetric metric = triangle_metric(Vec3(0, 0, 0), Vec3(1.01, 0, 0), Vec3(0, 1, 0));
    const double strain = 0.5 * (1.01 * 1.01 - 1);
    const double c11 = 20e3 / (1 - 0.2 * 0.2 * 0.7);
    EXPECT_NEAR(WovenMembrane(fabric).energy(metric, Mat22::Identity()), 0.5 * 0.5 * c11 * strain * strain, 1e-13);

    Mat22 swapped;  // the side in space now lies along the weft
    swapped << 0, 1, -1, 0;
    const double c22 = 0.7 * c11;
    EXPECT_NEAR(WovenMembrane(fabric).energy(metric, -swapped), 0.5 * 0.5 * c22 * strain * strain, 1e-13);
}

TEST(WovenMembrane, ShearByHand) {
    // Threads that cross at 90 - 3 degrees without stretch: 2 E12 = sin 3 degrees.
    const double angle = 3 * degree;
    const TriangleMetric metric =
        triangle_metric(Vec3::Zero(), Vec3(1, 0, 0), Vec3(std::sin(angle), std::cos(angle), 0));
    const double expected = 0.5 * 0.5 * 300 * std::sin(angle) * std::sin(angle);
    EXPECT_NEAR(WovenMembrane(balloon_cloth()).energy(metric, Mat22::Identity()), expected, 1e-13);
}

TEST(WovenMembrane, GradientIsTheDerivativeOfTheEnergy) {
    const WovenMembrane membrane(balloon_cloth());
    const TriangleMetric metric = triangle_metric(a, b, c);
    for (unsigned seed = 0; seed < 20; ++seed) {
        const Vec6 x = near_rest(0.1, seed);
        const auto energy = [&](const Eigen::VectorXd& y) {
            return Eigen::VectorXd::Constant(1, membrane.energy(metric, edges(y))).eval();
        };
        const MembraneElement element = membrane.element(metric, edges(x));
        EXPECT_DOUBLE_EQ(element.energy, energy(x)[0]);
        const Eigen::VectorXd measured = testing::jacobian(energy, x).transpose();
        EXPECT_LT((measured - element.gradient).norm(), 1e-7 * measured.norm()) << seed;
    }
}

TEST(WovenMembrane, HessianIsTheDerivativeOfTheGradient) {
    const WovenMembrane membrane(balloon_cloth());
    const TriangleMetric metric = triangle_metric(a, b, c);
    for (unsigned seed = 0; seed < 20; ++seed) {
        const Vec6 x = near_rest(0.1, seed);
        const auto gradient = [&](const Eigen::VectorXd& y) {
            return Eigen::VectorXd(membrane.element(metric, edges(y)).gradient);
        };
        const auto hessian = membrane.element(metric, edges(x)).hessian;
        const Eigen::MatrixXd measured = testing::jacobian(gradient, x);
        EXPECT_LT((measured - hessian).norm(), 1e-7 * measured.norm()) << seed;
        EXPECT_LT((hessian - hessian.transpose()).norm(), 1e-14 * hessian.norm());
    }
}

TEST(WovenMembrane, SemidefiniteHessianIsNoSmallerAndHasNoNegativeCurvature) {
    const WovenMembrane membrane(balloon_cloth());
    const TriangleMetric metric = triangle_metric(a, b, c);
    int indefinite = 0;
    for (unsigned seed = 0; seed < 50; ++seed) {
        const Mat22 flat = edges(near_rest(0.1, seed));
        const auto exact = membrane.element(metric, flat).hessian;
        const auto projected = membrane.element(metric, flat, Curvature::semidefinite).hessian;
        const auto smallest = [](const Eigen::Matrix<double, 6, 6>& m) {
            return Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>>(m).eigenvalues()[0];
        };
        EXPECT_GT(smallest(projected), -1e-12 * exact.norm()) << seed;
        EXPECT_GT(smallest(projected - exact), -1e-12 * exact.norm()) << seed;
        indefinite += smallest(exact) < -1e-9 * exact.norm();
    }
    EXPECT_GT(indefinite, 5);  // otherwise the test shows nothing
}

TEST(WovenMembrane, SemidefiniteHessianIsTheExactOneWhereTheClothIsSlightlyTooLarge) {
    // Cloth that is 0.1 % too large in every direction. A linear rotation of the corners enlarges it further,
    // which costs energy; the compression is far too small to overcome the shear stiffness.
    const WovenMembrane membrane(balloon_cloth());
    const TriangleMetric metric = triangle_metric(a, b, c);
    const Mat22 flat = 1.001 * lay_flat(a, b, c);
    EXPECT_EQ(membrane.element(metric, flat, Curvature::semidefinite).hessian, membrane.element(metric, flat).hessian);
}

TEST(WovenMembrane, IsInfiniteForATriangleTurnedOverAndGrowsTowardsIt) {
    const WovenMembrane membrane(balloon_cloth());
    const TriangleMetric metric = triangle_metric(a, b, c);
    Mat22 flat = lay_flat(a, b, c);
    double last = 0;
    for (const double height : {0.5, 0.1, 0.01, 1e-4}) {
        Mat22 squeezed = flat;
        squeezed.row(1) *= height;
        const double energy = membrane.energy(metric, squeezed);
        EXPECT_GT(energy, 10 * last);
        last = energy;
    }
    flat.row(1) *= -1;
    EXPECT_EQ(membrane.energy(metric, flat), std::numeric_limits<double>::infinity());
    EXPECT_EQ(membrane.element(metric, flat).energy, std::numeric_limits<double>::infinity());
    flat.row(1) *= 0;
    EXPECT_EQ(membrane.energy(metric, flat), std::numeric_limits<double>::infinity());
}

TEST(MembraneEnergy, SumsOverTheMeshAndIsZeroOnItsOwnPlane) {
    const TriangleMesh mesh = testing::rectangle(2, 1, 6, 4);
    const Points2 flat = mesh.positions.leftCols<2>();
    EXPECT_LT(membrane_energy(mesh, flat, balloon_cloth()), 1e-20);
    // Cloth that is 1 % too short along the warp: ½ c11 E² on the smaller flat area.
    Points2 shorter = flat;
    shorter.col(0) /= 1.01;
    const double strain = 0.5 * (1.01 * 1.01 - 1);
    const double expected = 2 / 1.01 * 0.5 * balloon_cloth().c11() * strain * strain;
    EXPECT_NEAR(membrane_energy(mesh, shorter, balloon_cloth()), expected, 1e-9 * expected);
    shorter.col(0) *= -1;
    EXPECT_EQ(membrane_energy(mesh, shorter, balloon_cloth()), std::numeric_limits<double>::infinity());
}

TEST(ThreadStrain, ReadsStretchAndShearOfTheMapFromClothToSpace) {
    const double angle = 5 * degree;
    const TriangleMetric metric =
        triangle_metric(Vec3::Zero(), Vec3(0, 1.02, 0), 0.97 * Vec3(0, std::sin(angle), std::cos(angle)));
    const ThreadStrain strain = thread_strain(metric, Mat22::Identity());
    EXPECT_NEAR(strain.warp, 0.02, 1e-14);
    EXPECT_NEAR(strain.weft, -0.03, 1e-14);
    EXPECT_NEAR(strain.shear, angle, 1e-14);
    const Mat22 green = (cauchy_green(metric, Mat22::Identity()) - Mat22::Identity()) / 2;
    EXPECT_NEAR(green(0, 0), 0.5 * (1.02 * 1.02 - 1), 1e-14);
    EXPECT_NEAR(green(0, 1), 0.5 * 1.02 * 0.97 * std::sin(angle), 1e-14);
}

TEST(ThreadStrain, DoesNotDependOnWhichCornerComesFirst) {
    const Vec6 x = near_rest(0.1, 3);
    Vec6 turned;
    turned << x.tail<4>(), x.head<2>();
    const ThreadStrain one = thread_strain(triangle_metric(a, b, c), edges(x));
    const ThreadStrain other = thread_strain(triangle_metric(b, c, a), edges(turned));
    EXPECT_NEAR(one.warp, other.warp, 1e-13);
    EXPECT_NEAR(one.weft, other.weft, 1e-13);
    EXPECT_NEAR(one.shear, other.shear, 1e-13);
}

TEST(ThreadStrain, IsInfiniteWhereTheClothHasNoArea) {
    Mat22 flat;
    flat << 1, 2, 1, 2;
    EXPECT_EQ(thread_strain(triangle_metric(a, b, c), flat).warp, std::numeric_limits<double>::infinity());
}

}  // namespace woven_membrane_test
}  // namespace ripstop
