#include "ripstop/energy/spring_network.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "ripstop/tile/make_tile.h"
#include "support/shapes.h"

namespace ripstop {
namespace spring_network_test {

Fabric woven() {
    Fabric fabric;
    fabric.warp_stiffness = 60e3;
    fabric.weft_stiffness = 50e3;
    return fabric;
}

Points2 flat_of(const TriangleMesh& mesh) {
    return mesh.positions.leftCols(2);
}

Points2 forces_at(const SpringNetwork& network, const Points2& x) {
    Points2 forces;
    energy_and_forces(network, x, Points2::Zero(x.rows(), 2), 0, forces);
    return forces;
}

TEST(SpringNetwork, RestsUnderRigidMotion) {
    const Tile tile = make_tile("t", testing::rectangle(2, 1, 4, 3));
    const SpringNetwork network = make_spring_network(tile, woven());
    Mat22 turn;
    turn << std::cos(0.3), -std::sin(0.3), std::sin(0.3), std::cos(0.3);
    const Points2 x = (flat_of(tile.mesh) * turn.transpose()).rowwise() + Eigen::RowVector2d(3, -1);
    EXPECT_LT(energy(network, x), 1e-20);
    EXPECT_LT(forces_at(network, x).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(SpringNetwork, StretchedEdgeByHand) {
    TriangleMesh mesh;
    mesh.positions.resize(3, 3);
    mesh.positions << 0, 0, 0, 2, 0, 0, 0, 1, 0;
    mesh.triangles.resize(1, 3);
    mesh.triangles << 0, 1, 2;
    const SpringNetwork network = make_spring_network(make_tile("t", mesh, {.warp = Vec3::UnitX()}), woven());
    // area 1: the edge along the warp has k = E_warp A / L^2 = 60e3 / 4, the one along the weft 50e3 / 1
    EXPECT_NEAR(network.springs[0].stiffness, 15e3, 1e-9);
    EXPECT_NEAR(network.springs[2].stiffness, 50e3, 1e-9);
    const double long_share = 4.0 / 5.0;
    EXPECT_NEAR(network.springs[1].stiffness, (60e3 * long_share + 50e3 * (1 - long_share)) / 5, 1e-9);
    Points2 x(3, 2);
    x << 0, 0, 2.1, 0, 0, 1;
    const double slanted = std::hypot(2.1, 1) - std::sqrt(5.0);
    EXPECT_NEAR(energy(network, x), 0.5 * 15e3 * 0.01 + 0.5 * network.springs[1].stiffness * slanted * slanted, 1e-9);
}

TEST(SpringNetwork, ForcesAreMinusTheGradientOfTheEnergy) {
    const Tile tile = make_tile("t", testing::spherical_square(0.4, 4));
    const SpringNetwork network = make_spring_network(tile, woven());
    std::mt19937 random(5);
    std::uniform_real_distribution<double> jitter(-0.15, 0.15);  // wide enough to trigger the guards in some triangles
    Points2 x = flat_of(tile.mesh);
    x = x.unaryExpr([&](double value) { return value + jitter(random) * 0.8; });
    const Points2 forces = forces_at(network, x);
    for (Eigen::Index i = 0; i < x.size(); ++i) {
        const double step = 1e-7;
        Points2 ahead = x, behind = x;
        ahead.data()[i] += step;
        behind.data()[i] -= step;
        const double slope = (energy(network, ahead) - energy(network, behind)) / (2 * step);
        EXPECT_NEAR(-forces.data()[i], slope, 1e-5 * forces.cwiseAbs().maxCoeff());
    }
}

TEST(SpringNetwork, PushesATurnedTriangleBack) {
    const Tile tile = make_tile("t", testing::rectangle(1, 1, 1, 1));
    const SpringNetwork network = make_spring_network(tile, woven());
    Points2 x = flat_of(tile.mesh);
    x.row(1) << 0.4, 0.6;  // beyond the diagonal: the triangle 0 1 3 is flipped
    const Points2 forces = forces_at(network, x);
    EXPECT_GT(forces(1, 0) - forces(1, 1), 0);
}

TEST(SpringNetwork, DampersTakeEnergyAndKeepMomentum) {
    const Tile tile = make_tile("t", testing::rectangle(1, 1, 2, 2));
    const SpringNetwork network = make_spring_network(tile, woven());
    std::mt19937 random(3);
    std::uniform_real_distribution<double> speed(-1, 1);
    Points2 v(9, 2);
    v = v.unaryExpr([&](double) { return speed(random); });
    Points2 forces;
    energy_and_forces(network, flat_of(tile.mesh), v, 1e-3, forces);
    EXPECT_LT((forces.array() * v.array()).sum(), 0);
    EXPECT_LT(forces.colwise().sum().norm(), 1e-9 * forces.norm());
}

TEST(SpringNetwork, EquilateralMeshImpliesItsStiffnessAndNuOneThird) {
    // Van Gelder 1998: springs with k = sum E A / L^2 on equilateral triangles are an isotropic membrane with E
    // and nu = 1/3.
    const int n = 24;
    TriangleMesh mesh =
        testing::grid(n, n, [](double u, double v) { return Vec3(n * u - n * v / 2, n * v * std::sqrt(0.75), 0); });
    Fabric fabric;
    const Tile tile = make_tile("t", mesh, {.warp = Vec3::UnitX()});
    const Eigen::Matrix3d C = implied_elasticity(make_spring_network(tile, fabric), tile);
    const double E = fabric.warp_stiffness, nu = 1.0 / 3;
    EXPECT_NEAR(C(0, 0), E / (1 - nu * nu), 1e-6 * E);
    EXPECT_NEAR(C(0, 1), nu * E / (1 - nu * nu), 1e-6 * E);
    EXPECT_NEAR(C(2, 2), E / (2 * (1 + nu)), 1e-6 * E);
}

TEST(SpringNetwork, ForcesShearToEqualCrossStiffnessWhateverTheFabric) {
    const Tile tile = make_tile("t", testing::spherical_square(0.3, 6), {.warp = Vec3(1, 2, 0)});
    const Eigen::Matrix3d C = implied_elasticity(make_spring_network(tile, woven()), tile);
    EXPECT_NEAR(C(0, 1), C(2, 2), 1e-9 * C(0, 0));
    EXPECT_GT(C(2, 2), 5e3);
}

TEST(SpringNetwork, FrequencyBoundIsAbove) {
    // one edge between two particles of mass m: omega = sqrt(2 k / m)
    SpringNetwork network;
    network.springs = {{0, 1, 1.0, 8.0}};
    network.mass = Eigen::Vector2d(0.5, 0.5);
    EXPECT_GE(frequency_bound(network), std::sqrt(2 * 8 / 0.5) * (1 - 1e-12));
}

}  // namespace spring_network_test
}  // namespace ripstop
