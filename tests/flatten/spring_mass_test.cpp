#include "ripstop/flatten/spring/spring_mass.h"

#include <gtest/gtest.h>

#include <cmath>

#include "ripstop/base/error.h"
#include "ripstop/tile/make_tile.h"
#include "support/shapes.h"

namespace ripstop {
namespace spring_mass_test {

struct Rolled {
    Tile tile;
    SpringNetwork network;
    Points2 exact;
};

Rolled rolled() {
    Rolled setup{make_tile("t", testing::cylinder(1, 1.2, 2, 10, 12)), {}, {}};
    setup.network = make_spring_network(setup.tile, Fabric{});
    const double facet = 2 * std::sin(0.06);
    setup.exact.resize(11 * 13, 2);
    for (int j = 0; j <= 12; ++j)
        for (int i = 0; i <= 10; ++i) setup.exact.row(j * 11 + i) << facet * i, 2.0 * j / 12;
    return setup;
}

Points2 squeezed(const Points2& x) {
    return x * Eigen::Vector2d(0.9, 1.07).asDiagonal();
}

TEST(SpringMass, LeavesAnIsometryAlone) {
    const Rolled setup = rolled();
    const SpringMassRun run = relax_spring_mass(setup.network, setup.exact);
    EXPECT_EQ(run.summary.termination, Termination::converged);
    EXPECT_LT((run.positions - setup.exact).norm(), 1e-9);
    EXPECT_LE(run.summary.iterations, 10);
}

TEST(SpringMass, FindsTheIsometryOfADevelopableTile) {
    const Rolled setup = rolled();
    const SpringMassRun run = relax_spring_mass(setup.network, squeezed(setup.exact));
    EXPECT_EQ(run.summary.termination, Termination::converged) << run.summary.text();
    EXPECT_EQ(run.halvings, 0);
    for (const Spring& spring : setup.network.springs)
        EXPECT_NEAR((run.positions.row(spring.b) - run.positions.row(spring.a)).norm(), spring.rest,
                    1e-8 * spring.rest);
}

TEST(SpringMass, AdaptiveStepReachesTheSameRestInFewerSteps) {
    const Rolled setup = rolled();
    const SpringMassRun fixed = relax_spring_mass(setup.network, squeezed(setup.exact), {.step = 0.4});
    const SpringMassRun adaptive =
        relax_spring_mass(setup.network, squeezed(setup.exact), {.step = 0.4, .adaptive = true});
    EXPECT_EQ(adaptive.summary.termination, Termination::converged);
    EXPECT_LT(adaptive.summary.iterations, fixed.summary.iterations);
}

TEST(SpringMass, InstabilityIsCaughtAndTheStepHalved) {
    // with this frequency bound the masses are far too light, so the first steps would diverge
    Rolled setup = rolled();
    const SpringMassRun run =
        relax_spring_mass(setup.network, squeezed(setup.exact) * 2.5, {.damping = 1, .step = 1.999});
    EXPECT_TRUE(run.positions.allFinite());
    EXPECT_LE(run.energy, energy(setup.network, squeezed(setup.exact) * 2.5));
    EXPECT_EQ(run.summary.termination, Termination::converged) << run.summary.text();
}

TEST(SpringMass, NeverEndsAboveTheEnergyItStartedFrom) {
    const Tile tile = make_tile("t", testing::octant(8));
    const SpringNetwork network = make_spring_network(tile, Fabric{});
    const Points2 start = tile.mesh.positions.leftCols(2) + 0.3 * tile.mesh.positions.rightCols(2);
    const SpringMassRun run = relax_spring_mass(network, start);
    EXPECT_LT(run.energy, energy(network, start));
    EXPECT_EQ(run.summary.termination, Termination::converged);
}

TEST(SpringMass, SaysWhenItRanOutOfSteps) {
    const Rolled setup = rolled();
    const SpringMassRun run = relax_spring_mass(setup.network, squeezed(setup.exact), {.max_steps = 3});
    EXPECT_EQ(run.summary.termination, Termination::iteration_limit);
    EXPECT_EQ(run.summary.iterations, 3);
}

TEST(SpringMass, RefusesOptionsOutOfRange) {
    const Rolled setup = rolled();
    EXPECT_THROW(relax_spring_mass(setup.network, setup.exact, {.step = 2.5}), InputError);
    EXPECT_THROW(relax_spring_mass(setup.network, setup.exact, {.energy_tolerance = 0}), InputError);
}

}  // namespace spring_mass_test
}  // namespace ripstop
