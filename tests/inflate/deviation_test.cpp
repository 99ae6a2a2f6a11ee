#include "ripstop/inflate/deviation.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "ripstop/inflate/inflate.h"
#include "ripstop/pipeline/read/read_envelope.h"
#include "ripstop/tile/make_tile.h"
#include "support/sewn.h"
#include "support/shapes.h"

namespace ripstop {
namespace deviation_test {

/// Compares the drawn unit sphere of twelve gores with the same vertices moved by `move`.
template <class Move>
Inflated compared(CutPlan& plan, Move&& move) {
    Inflated inflated;
    plan.tiles.clear();
    for (const Tile& tile : testing::gores({0.5235987755982988}, 12, 6, 48).tiles) {
        plan.tiles.push_back({tile, {}, {}, {}, {}, {}});
        InflatedTile there;
        there.positions = tile.mesh.positions;
        for (Eigen::Index v = 0; v < there.positions.rows(); ++v)
            there.positions.row(v) = move(Vec3(there.positions.row(v))).transpose();
        inflated.tiles.push_back(there);
    }
    measure_deviation(plan, 0, inflated);
    return inflated;
}

TEST(Deviation, OfALargerShapeIsPositiveAndOfASmallerOneNegative) {
    CutPlan plan;
    const Inflated larger = compared(plan, [](const Vec3& x) { return Vec3(1.01 * x); });
    EXPECT_NEAR(larger.off.rms, 0.01, 2e-4);  // facets
    EXPECT_NEAR(larger.off.max, 0.01, 2e-4);
    EXPECT_NEAR(larger.off.moved_rms, 0.01, 1e-12);
    EXPECT_NEAR(larger.off.moved_max, 0.01, 1e-12);
    const Inflated smaller = compared(plan, [](const Vec3& x) { return Vec3(0.99 * x); });
    EXPECT_NEAR(smaller.off.rms, 0.01, 2e-4);
    EXPECT_NEAR(smaller.off.max, -0.01, 2e-4);
    for (const InflatedTile& tile : smaller.tiles) EXPECT_LT(tile.deviation.maxCoeff(), -0.009);
}

TEST(Deviation, ClothThatOnlyMovesAlongTheSurfaceIsNotOffIt) {
    CutPlan plan;
    const Eigen::AngleAxisd turn(0.02, Vec3::UnitZ());
    const Inflated turned = compared(plan, [&](const Vec3& x) { return Vec3(turn * x); });
    EXPECT_NEAR(turned.off.moved_rms, 0.02 * std::sqrt(2.0 / 3), 2e-4);  // mean of sin² over the sphere
    EXPECT_LT(turned.off.rms, 0.0025);                                   // facets 0.09 wide are 1 mm deep
}

/// A strip of 4,000 equal triangles, each 0.025 % of it, under a uniform tension.
Inflated strip(double tension, CutPlan& plan) {
    FlatTile flat;
    flat.tile = make_tile("strip", testing::rectangle(4, 1, 40, 50), {.warp = Vec3(1, 0, 0)});
    flat.flattening.positions = flat.tile.mesh.positions.leftCols<2>();
    plan.tiles = {flat};
    Inflated inflated;
    inflated.tiles.resize(1);
    inflated.tiles[0].tension = Points2::Constant(flat.tile.mesh.triangle_count(), 2, tension);
    return inflated;
}

TEST(SafetyFactors, LeaveOutAThousandthOfTheClothWhereSeamsEnd) {
    CutPlan plan;
    plan.fabric.strength = 10e3;
    Inflated inflated = strip(130, plan);
    inflated.tiles[0].tension.topRows(3).setConstant(5000);
    EXPECT_EQ(safety_factors(inflated, plan, {})[0].load, 130);
    inflated.tiles[0].tension.topRows(5).setConstant(5000);
    EXPECT_EQ(safety_factors(inflated, plan, {})[0].load, 5000);
    EXPECT_EQ(safety_factors(inflated, plan, {})[0].where, "tile strip");
}

TEST(SafetyFactors, AreWhatIsLeftOfTheStrengthOverTheLimitLoad) {
    // 462 N in a tape of 5 kN, 130 N/m in a cloth of 10 kN/m, limit load 1.4.
    CutPlan plan;
    plan.fabric.strength = 10e3;
    plan.seams.resize(1);
    plan.seams[0].id = "S1";
    Inflated inflated = strip(130, plan);
    inflated.tapes.push_back({TapeKind::load, 0, 462, 300, 1});
    inflated.tapes.push_back({TapeKind::wire, 2, 500, 500, 3});
    Rigging rigging;
    rigging.load_tape.strength = 5e3;
    rigging.wire.strength = 4e3;
    const std::vector<SafetyFactor> factors = safety_factors(inflated, plan, rigging);
    ASSERT_EQ(factors.size(), 3u);
    EXPECT_EQ(factors[0].part, "cloth");
    EXPECT_NEAR(factors[0].factor, 0.2 * 10e3 / (1.4 * 130), 1e-9);
    EXPECT_TRUE(factors[0].ok());
    EXPECT_EQ(factors[1].part, "load tapes");
    EXPECT_NEAR(factors[1].factor, 3.865, 1e-3);  // below 5
    EXPECT_FALSE(factors[1].ok());
    EXPECT_EQ(factors[1].where, "seam S1");
    EXPECT_EQ(factors[2].part, "wires");
    EXPECT_NEAR(factors[2].factor, 4e3 / (1.4 * 500), 1e-9);
    EXPECT_TRUE(factors[2].ok());
    inflated.safety = factors;
    EXPECT_FALSE(inflated.is_safe());
}

}  // namespace deviation_test
}  // namespace ripstop
