#include "ripstop/tile/allowance.h"

#include <gtest/gtest.h>

#include "support/seams.h"

namespace ripstop {
namespace allowance_test {

/// `left`, 1 m x 2 m; on its right side `low` and `high`, 1 m x 1 m each: 5 edges of these sheets are free.
CutPlan plan_of_types() {
    CutPlan plan = testing::sewn_plan();
    plan.seams[0].type.allowance = 0.03;
    plan.seams[1].type.allowance = 0.02;
    plan.seams[2].type = {"plain", 0.013, 1, false};
    for (FlatTile& tile : plan.tiles)
        for (Chain& chain : tile.tile.chains) chain.finish = {"hem", 0.04, 2, false};
    return plan;
}

TEST(EdgeAllowances, AreThoseOfTheSeamAndOfTheFinishWhereThereIsNone) {
    const CutPlan plan = plan_of_types();
    const std::vector<Eigen::VectorXd> allowances = edge_allowances(plan);
    ASSERT_EQ(allowances.size(), 3U);
    for (std::size_t t = 0; t < 3; ++t) {
        const Tile& tile = plan.tiles[t].tile;
        ASSERT_EQ(allowances[t].size(), static_cast<Eigen::Index>(tile.boundary.size()));
        for (std::size_t i = 0; i < tile.boundary.size(); ++i) {
            const Vec3 a = tile.mesh.positions.row(tile.boundary[i]);
            const Vec3 b = tile.mesh.positions.row(tile.boundary[(i + 1) % tile.boundary.size()]);
            const Vec3 middle = (a + b) / 2;
            double expected = 0.04;
            if (middle.x() == 1) expected = middle.y() < 1 ? 0.03 : 0.02;
            if (middle.x() > 1 && middle.y() == 1) expected = 0.013;
            EXPECT_EQ(allowances[t][static_cast<Eigen::Index>(i)], expected) << tile.name << " " << middle.transpose();
        }
    }
}

TEST(EdgeAllowances, AreTheWiderWhereAnEdgeIsOnlyPartlySewn) {
    CutPlan plan = plan_of_types();
    plan.seams.resize(1);
    SeamPart& last = plan.seams[0].a.parts.back();
    last.length /= 2;
    EXPECT_EQ(edge_allowances(plan)[static_cast<std::size_t>(plan.seams[0].a.tile)][last.edge], 0.04);
    plan.seams[0].type.allowance = 0.05;
    EXPECT_EQ(edge_allowances(plan)[static_cast<std::size_t>(plan.seams[0].a.tile)][last.edge], 0.05);
}

TEST(FreeLengths, AreWhatNoSeamHolds) {
    const std::vector<Eigen::VectorXd> left = free_lengths(plan_of_types());
    // without the metres of the seams: 6 - 2 of the left sheet, 4 - 2 of each other; sums of binary fractions of a
    // metre
    EXPECT_NEAR(left[0].sum(), 4, 1e-12);
    EXPECT_NEAR(left[1].sum(), 2, 1e-12);
    EXPECT_NEAR(left[2].sum(), 2, 1e-12);
}

TEST(SeamTypesUsed, CountSeamsAndFreeEdgesByTypeAndAllowance) {
    const std::vector<SeamTypeUse> uses = seam_types_used(plan_of_types());
    ASSERT_EQ(uses.size(), 4U);
    EXPECT_EQ(uses[0].type.name, "flat-felled");
    EXPECT_EQ(uses[0].type.allowance, 0.03);
    EXPECT_EQ(uses[0].seams, 1);
    EXPECT_EQ(uses[1].type.allowance, 0.02);
    EXPECT_EQ(uses[2].type.name, "plain");
    EXPECT_EQ(uses[3].type.name, "hem");
    EXPECT_EQ(uses[3].seams, 0);
    EXPECT_EQ(uses[3].free_edges, 7);
    EXPECT_NEAR(uses[3].length, 8, 1e-12);
}

TEST(SeamTypes, OfTheProgramAreSoundAndTheDefaultsAmongThem) {
    EXPECT_EQ(seam_types().front(), SeamType{});
    bool has_hem = false;
    for (const SeamType& type : seam_types()) {
        EXPECT_FALSE(type.name.empty());
        EXPECT_GE(type.allowance, 0);
        has_hem = has_hem || type == default_hem();
    }
    EXPECT_TRUE(has_hem);
    EXPECT_EQ(default_hem().name, "hem");
}

}  // namespace allowance_test
}  // namespace ripstop
