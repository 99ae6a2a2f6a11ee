#include "ripstop/energy/gas_pressure.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>

#include "support/finite_difference.h"
#include "support/shapes.h"

namespace ripstop {
namespace gas_pressure_test {

const GasPressure both{30, 2.7, -4};

Vec3 corner(const Eigen::VectorXd& x, int k) {
    return x.segment<3>(3 * k);
}

/// A closed skin: the eight octants of a sphere, with every vertex moved at random, consistently in all octants.
std::vector<std::array<Vec3, 3>> random_closed_skin() {
    const TriangleMesh octant = testing::octant(5);
    const auto moved = [](const Vec3& at) {
        const Vec3 wave(std::sin(7 * at.x() + 3 * at.y() + 1), std::sin(5 * at.y() - 4 * at.z()),
                        std::sin(6 * at.z() + at.x()));
        return Vec3(3 * at + 0.6 * wave + Vec3(10, -7, 2));
    };
    std::vector<std::array<Vec3, 3>> triangles;
    for (int which = 0; which < 8; ++which) {
        const Vec3 sign(which & 1 ? -1 : 1, which & 2 ? -1 : 1, which & 4 ? -1 : 1);
        for (int t = 0; t < octant.triangle_count(); ++t) {
            std::array<Vec3, 3> x;
            for (int k = 0; k < 3; ++k) x[static_cast<std::size_t>(k)] = moved(octant.corner(t, k).cwiseProduct(sign));
            if (sign.prod() < 0) std::swap(x[1], x[2]);
            triangles.push_back(x);
        }
    }
    return triangles;
}

double enclosed(const std::vector<std::array<Vec3, 3>>& skin) {
    double volume = 0;
    for (const auto& x : skin) volume += x[0].dot(x[1].cross(x[2])) / 6;
    return volume;
}

struct Load {
    Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
    double scale = 0;  ///< sum of the absolute values
};

Load load_on(const std::vector<std::array<Vec3, 3>>& skin, const GasPressure& gas) {
    Load load;
    for (const auto& x : skin) {
        const SpaceElement element = gas_element(gas, x[0], x[1], x[2]);
        for (int k = 0; k < 3; ++k) {
            const Vec3 force = -element.gradient.segment<3>(3 * k);
            load.force += force;
            load.moment += x[static_cast<std::size_t>(k)].cross(force);
            load.scale += force.norm();
        }
    }
    return load;
}

TEST(GasPressure, GradientAndHessianAreTheDerivatives) {
    std::mt19937 random(5);
    std::normal_distribution<double> normal;
    for (int k = 0; k < 50; ++k) {
        const Eigen::VectorXd x = Eigen::VectorXd::NullaryExpr(9, [&] { return normal(random); });
        const auto energy = [](const Eigen::VectorXd& at) {
            return Eigen::VectorXd::Constant(1, gas_energy(both, corner(at, 0), corner(at, 1), corner(at, 2))).eval();
        };
        const auto gradient = [](const Eigen::VectorXd& at) -> Eigen::VectorXd {
            return gas_element(both, corner(at, 0), corner(at, 1), corner(at, 2)).gradient;
        };
        const SpaceElement element = gas_element(both, corner(x, 0), corner(x, 1), corner(x, 2));
        EXPECT_EQ(element.energy, energy(x)[0]);
        EXPECT_LT((testing::jacobian(energy, x).transpose() - element.gradient).norm(), 1e-7);  // of some 100 N
        EXPECT_LT((testing::jacobian(gradient, x) - element.hessian).norm(), 1e-7);
        EXPECT_LT((element.hessian - element.hessian.transpose()).norm(), 1e-13 * element.hessian.norm());
    }
}

TEST(GasPressure, EnergyOfAClosedSkinIsMinusTheIntegralOfThePressure) {
    const auto skin = random_closed_skin();
    double constant = 0, linear = 0;
    for (const auto& x : skin) {
        constant += gas_energy({5, 0, 1.5}, x[0], x[1], x[2]);
        linear += gas_energy({0, 2, 1.5}, x[0], x[1], x[2]);
    }
    EXPECT_NEAR(constant, -5 * enclosed(skin), 1e-10);
    double lever = 0;  // integral of z dV over the tetrahedra to the origin
    for (const auto& x : skin) lever += x[0].dot(x[1].cross(x[2])) / 6 * (x[0].z() + x[1].z() + x[2].z()) / 4;
    EXPECT_NEAR(linear, -2 * (lever - 1.5 * enclosed(skin)), 1e-9);
}

TEST(GasPressure, RisingPressureLiftsByTheVolumeAndNeverSideways) {
    const auto skin = random_closed_skin();
    for (const double base : {0.0, 30.0}) {
        const Load load = load_on(skin, {base, 2.7, -4});
        EXPECT_NEAR(load.force.z(), 2.7 * enclosed(skin), 1e-13 * load.scale);
        EXPECT_LT(load.force.head<2>().norm(), 1e-13 * load.scale);
    }
}

TEST(GasPressure, EvenPressureNeitherMovesNorTurns) {
    const Load load = load_on(random_closed_skin(), {30, 0, -4});
    EXPECT_LT(load.force.norm(), 1e-13 * load.scale);
    EXPECT_LT(load.moment.norm(), 1e-12 * load.scale);  // lever arms of ten metres
}

TEST(GasPressure, AVertexGetsAThirdOfThePressureOnTheTrianglesRoundIt) {
    const Vec3 middle(0.2, -0.1, 2);
    Vec3 force = Vec3::Zero(), expected = Vec3::Zero();
    const auto rim = [](int k) { return Vec3(std::cos(k * 1.2566), std::sin(k * 1.2566), 1 + 0.3 * (k % 5)); };
    for (int k = 0; k < 5; ++k) {
        const Vec3 b = rim(k), c = k == 4 ? rim(0) : rim(k + 1);
        force -= gas_element({30, 0, -1}, middle, b, c).gradient.head<3>();
        expected += 30 * 0.5 * (b - middle).cross(c - middle) / 3;
    }
    EXPECT_LT((force - expected).norm(), 1e-12);
}

TEST(GasPressure, AMouthInTheFloorsPlaneNeedsNoCap) {
    // Half a sphere, open downwards at the floor: the lift is b V, straight up.
    const TriangleMesh octant = testing::octant(6);
    std::vector<std::array<Vec3, 3>> skin;
    for (int turn = 0; turn < 4; ++turn)
        for (int t = 0; t < octant.triangle_count(); ++t) {
            const Eigen::AngleAxisd about(std::numbers::pi / 2 * turn, Vec3::UnitZ());
            skin.push_back({about * octant.corner(t, 0), about * octant.corner(t, 1), about * octant.corner(t, 2)});
        }
    const Load load = load_on(skin, {0, 2.7, 0});
    double volume = 0;
    for (const auto& x : skin) volume -= gas_energy({1, 0, 0}, x[0], x[1], x[2]);
    EXPECT_NEAR(volume, enclosed(skin), 1e-13);  // the cap adds nothing, because it passes through the origin
    EXPECT_NEAR(load.force.z(), 2.7 * volume, 1e-13 * load.scale);
    EXPECT_LT(load.force.head<2>().norm(), 1e-13 * load.scale);
}

}  // namespace gas_pressure_test
}  // namespace ripstop
