/// A special shape, neither a body of revolution nor an equilibrium: from its drawing to the shape it can hold.
#include <gtest/gtest.h>

#include <fstream>

#include "ripstop/design/special/special.h"
#include "ripstop/flatten/method.h"
#include "ripstop/inflate/sew.h"
#include "ripstop/io/json/fabric_json.h"
#include "ripstop/io/json/special_json.h"
#include "ripstop/pipeline/flatten/flatten_envelope.h"
#include "ripstop/pipeline/flight/inflate_plan.h"
#include "ripstop/pipeline/read/read_envelope.h"
#include "support/sanitized.h"

namespace ripstop {
namespace special_shape_under_gas_test {

CutPlan cut_example() {
    std::ifstream in(RIPSTOP_SOURCE_DIR "/docs/special.example.json");
    SpecialShape shape = read_special_shape(in, "special.example.json");
    shape.edge_length = 0.16;
    ReadOptions reading;
    reading.fabric = fabric_named("nylon");
    FlattenOptions flattening;
    flattening.fabric = reading.fabric;
    return flatten_envelope(make_envelope(design_special(shape), reading), flattening);
}

TEST(SpecialShapeUnderGas, IsSewnInflatedAndToldWhatItCanHold) {
    RIPSTOP_TOO_LONG_SANITIZED();
    const CutPlan plan = cut_example();
    EXPECT_GE(plan.tiles.size(), 200U);
    for (const SeamWalk& walk : plan.walks) EXPECT_LT(walk.drift_max, 1e-4 * walk.length);
    const Inflated inflated = inflate_plan(plan, {});
    ASSERT_EQ(inflated.summary.termination, Termination::converged) << inflated.summary.reason;
    EXPECT_TRUE(inflated.is_stable);
    EXPECT_EQ(inflated.sectors, 1);
    EXPECT_LT(std::abs(inflated.imbalance), 1e-6) << "lift = b V - W";
    EXPECT_LT(inflated.seam_gap, 1e-6);
    // A handle, ears and a nose of a skin under pressure lose about 3 % of the volume. Perfect patterns and
    // inextensible cloth would not help.
    EXPECT_NEAR(inflated.off.moved_rms, 0.015 * inflated.drawn_height, 0.004 * inflated.drawn_height);
    EXPECT_NEAR(inflated.volume / inflated.drawn_volume, 0.975, 0.01);
    ASSERT_TRUE(inflated.causes);
    EXPECT_GT(inflated.causes->shape, 2 * inflated.causes->stretch);
    EXPECT_LT(inflated.causes->patterns, 0.5 * inflated.causes->shape);
    EXPECT_NEAR(inflated.lift, 115, 5);
}

TEST(SpecialShapeUnderGas, ComesToOneStateFromSeveralStarts) {
    RIPSTOP_TOO_LONG_SANITIZED();
    const CutPlan plan = cut_example();
    InflateOptions options;
    options.sewing.symmetry = no_symmetry(plan);
    const Inflated warm = inflate(plan, options);
    for (const FlatTile& tile : plan.tiles) {
        Points3 there = 0.95 * tile.tile.mesh.positions;
        there.col(0).array() += 0.05 * (3 * tile.tile.mesh.positions.col(2).array()).sin();
        options.start.push_back(there);
    }
    const Inflated cold = inflate(plan, options);
    ASSERT_EQ(cold.summary.termination, Termination::converged) << cold.summary.reason;
    double apart = 0;
    for (std::size_t i = 0; i < plan.tiles.size(); ++i)
        apart = std::max(apart, (warm.tiles[i].positions - cold.tiles[i].positions).rowwise().norm().maxCoeff());
    EXPECT_LT(apart, 1e-3);
}

}  // namespace special_shape_under_gas_test
}  // namespace ripstop
