#include "ripstop/inflate/equilibrium.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "ripstop/pipeline/flatten/flatten_envelope.h"
#include "ripstop/pipeline/flight/find_symmetry.h"
#include "ripstop/pipeline/read/read_envelope.h"
#include "support/balloons.h"
#include "support/envelopes.h"
#include "support/sanitized.h"

namespace ripstop {
namespace equilibrium_test {

using namespace testing;

const EnvelopeDesign lobed{.gores = 8, .panels = 3, .bulge = 30 * degree, .edge_length = 0.9};
const EnvelopeDesign smooth{.gores = 8, .panels = 3, .edge_length = 0.9};

SewnEnvelope sewn_balloon(const EnvelopeDesign& design, bool one_sector) {
    const CutPlan plan = cut_balloon(design, design.bulge > 0);
    SewOptions options;
    if (one_sector) options.symmetry = find_symmetry(plan);
    options.rigging.foreshortening = design.bulge > 0 ? 0.01 : 0;
    return sew(plan, options);
}

double farthest(const Points3& a, const Points3& b) {
    return (a - b).rowwise().norm().maxCoeff();
}

/// Moves every free direction at random.
Points3 shaken(const SewnEnvelope& sewn, const Points3& nodes, double by) {
    std::mt19937 random(4);
    std::normal_distribution<double> normal(0, by);
    Points3 moved = nodes;
    for (Eigen::Index n = 0; n < nodes.rows(); ++n)
        for (int axis = 0; axis < 3; ++axis)
            if (may_move(sewn.freedom[static_cast<std::size_t>(n)], axis)) moved(n, axis) += normal(random);
    return moved;
}

TEST(Balance, ForcesAndStiffnessOfAWholeEnvelopeAreTheDerivatives) {
    // One sector of eight, with sides that are rotated copies of each other, tapes, wires, a crown ring and a cap;
    // and a wall of tiles that hang on each other's edges.
    for (const bool with_t_junctions : {false, true}) {
        SewnEnvelope sewn = with_t_junctions ? sew(flatten_envelope(make_envelope(brick_wall(3, 4), {}), {}))
                                             : sewn_balloon(lobed, true);
        Balance balance(sewn, {10, 2.7, sewn.floor - 1}, 1);
        // Stretched everywhere, so that no triangle is near a jump of its stiffness.
        Points3 nodes = shaken(sewn, sewn.nodes, 1e-3);
        for (Eigen::Index n = 0; n < nodes.rows(); ++n)
            for (int axis = 0; axis < 3; ++axis)
                if (may_move(sewn.freedom[static_cast<std::size_t>(n)], axis)) nodes(n, axis) *= 1.02;
        Eigen::VectorXd gradient, values;
        const double energy = balance.assemble(nodes, gradient, values);
        EXPECT_NEAR(energy, balance.energy(nodes), 1e-12 * std::abs(energy));
        EXPECT_LT((gradient - balance.gradient(nodes)).norm(), 1e-12 * gradient.norm());
        std::mt19937 random(1);
        std::normal_distribution<double> normal;
        for (int k = 0; k < 5; ++k) {
            const Eigen::VectorXd way =
                Eigen::VectorXd::NullaryExpr(balance.unknowns(), [&] { return normal(random); });
            constexpr double step =
                1e-8;  // short, so that none of thousands of triangles changes from taut to wrinkled
            const Points3 up = balance.moved(nodes, step * way), down = balance.moved(nodes, -step * way);
            const double rise = (balance.energy(up) - balance.energy(down)) / (2 * step);
            EXPECT_NEAR(rise, gradient.dot(way), 1e-6 * gradient.norm() * way.norm());
            const Eigen::VectorXd change = (balance.gradient(up) - balance.gradient(down)) / (2 * step);
            const Eigen::VectorXd expected = product(balance.pattern(), values, way);
            EXPECT_LT((change - expected).norm(), 1e-6 * expected.norm());
        }
    }
}

TEST(Equilibrium, CarriesTheVolumeTimesTheRiseLessItsWeight) {
    for (const EnvelopeDesign& design : {smooth, lobed})
        for (const bool one_sector : {false, true}) {
            const SewnEnvelope sewn = sewn_balloon(design, one_sector);
            const Equilibrium found = rest(sewn, sewn.nodes);
            ASSERT_EQ(found.summary.termination, Termination::converged);
            EXPECT_TRUE(found.is_stable);
            Balance balance(sewn, hot_air(sewn), 0);
            balance.set_residual(1e-4);
            const double lift = balance.lift(found.nodes);
            EXPECT_NEAR(lift, balance.net_lift(found.nodes), 1e-9 * lift);
            const double by_volume = balance.gas().rise * balance.volume(found.nodes) - balance.weight();
            EXPECT_NEAR(lift - balance.thrust_on_lids(found.nodes), by_volume, 1e-9 * lift);
        }
}

TEST(Equilibrium, OfOneSectorIsThatOfTheWholeEnvelope) {
    RIPSTOP_TOO_LONG_SANITIZED();
    for (const EnvelopeDesign& design : {smooth, lobed}) {
        const SewnEnvelope sector = sewn_balloon(design, true), whole = sewn_balloon(design, false);
        EXPECT_EQ(sector.sectors, 8);
        EXPECT_EQ(whole.sectors, 1);
        const Equilibrium one = rest(sector, sector.nodes), all = rest(whole, whole.nodes);
        EXPECT_LT(farthest(all_vertices(sector, one.nodes), all_vertices(whole, all.nodes)), 1e-6);
        EXPECT_NEAR(8 * one.energy, all.energy, 1e-10 * std::abs(all.energy));
    }
}

TEST(Equilibrium, DoesNotDependOnTheStart) {
    const SewnEnvelope sewn = sewn_balloon(lobed, true);
    const Equilibrium from_drawn = rest(sewn, sewn.nodes);
    Points3 smaller = sewn.nodes;
    for (Eigen::Index n = 0; n < smaller.rows(); ++n)
        for (int axis = 0; axis < 3; ++axis)
            if (may_move(sewn.freedom[static_cast<std::size_t>(n)], axis)) smaller(n, axis) *= 0.9;
    const Equilibrium found = rest(sewn, shaken(sewn, smaller, 0.05));
    ASSERT_EQ(found.summary.termination, Termination::converged);
    EXPECT_LT(farthest(found.nodes, from_drawn.nodes), 1e-3);
}

TEST(Equilibrium, IsWhereRelaxationWithoutAMatrixComesToRest) {
    EnvelopeDesign design = lobed;
    design.edge_length = 1.5;
    const SewnEnvelope sewn = sewn_balloon(design, true);
    const Equilibrium newton = rest(sewn, sewn.nodes);
    Balance balance(sewn, hot_air(sewn), 1);
    balance.set_residual(1e-4);
    const Equilibrium slow = relax_dynamically(balance, sewn.nodes, 20000, 1e-4);
    ASSERT_EQ(slow.summary.termination, Termination::converged);
    EXPECT_NEAR(slow.energy, newton.energy, 1e-7 * std::abs(newton.energy));
    EXPECT_GE(slow.energy, newton.energy - 1e-12 * std::abs(newton.energy));
    EXPECT_LT(farthest(slow.nodes, newton.nodes), 2e-3);  // the uncertainty at residual forces of 1e-4
}

TEST(Equilibrium, HardlyDependsOnTheResidualStiffness) {
    for (const EnvelopeDesign& design : {smooth, lobed}) {
        const SewnEnvelope sewn = sewn_balloon(design, true);
        const Equilibrium usual = rest(sewn, sewn.nodes), soft = rest(sewn, sewn.nodes, 1e-6);
        ASSERT_EQ(soft.summary.termination, Termination::converged);
        const Balance balance(sewn, hot_air(sewn), 0);
        EXPECT_NEAR(balance.volume(usual.nodes), balance.volume(soft.nodes), 5e-4 * balance.volume(soft.nodes));
        EXPECT_LT(farthest(usual.nodes, soft.nodes), 0.01);  // 0.05 % of the height
    }
}

TEST(Equilibrium, DoesNotDependOnTheNumberOfThreads) {
    const SewnEnvelope sewn = sewn_balloon(smooth, true);
    Balance one(sewn, hot_air(sewn), 1), many(sewn, hot_air(sewn), 5);
    EXPECT_EQ(find_equilibrium(one, sewn.nodes).nodes, find_equilibrium(many, sewn.nodes).nodes);
}

TEST(Equilibrium, SaysSoWhereItDoesNotGetThere) {
    const SewnEnvelope sewn = sewn_balloon(lobed, true);
    Balance balance(sewn, hot_air(sewn), 0);
    const Equilibrium found = find_equilibrium(balance, sewn.nodes, {.iterations = 2});
    EXPECT_EQ(found.summary.termination, Termination::iteration_limit);
    EXPECT_GT(found.residual, 1e-4);
    EXPECT_FALSE(found.is_stable);
}

}  // namespace equilibrium_test
}  // namespace ripstop
