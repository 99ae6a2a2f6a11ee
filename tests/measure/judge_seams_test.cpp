#include "ripstop/measure/judge_seams.h"

#include <gmock/gmock.h>

#include "ripstop/measure/judge.h"
#include "ripstop/measure/measure_accuracy.h"
#include "ripstop/measure/walk_seams.h"
#include "ripstop/tile/make_tile.h"
#include "support/seams.h"
#include "support/sewn.h"
#include "support/shapes.h"

namespace ripstop {
namespace judge_seams_test {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

std::vector<std::string> codes(const std::vector<Finding>& findings) {
    std::vector<std::string> result;
    for (const Finding& finding : findings) result.push_back(finding.code);
    return result;
}

/// Two unit squares side by side, cut with these heights and judged with their seam.
CutPlan squares(double left_height, double right_height, int sewn_edges = 4) {
    TriangleMesh right = testing::rectangle(1, 1, 4, 4);
    right.positions.col(0).array() += 1;
    Envelope envelope = testing::sewn({make_tile("left", testing::rectangle(1, 1, 4, 4), {.warp = Vec3::UnitX()}),
                                       make_tile("right", right, {.warp = Vec3::UnitX()})});
    CutPlan plan;
    plan.tiles = testing::laid_flat(envelope);
    for (std::size_t t = 0; t < 2; ++t) {
        FlatTile& tile = plan.tiles[t];
        tile.flattening.positions.col(1) *= t == 0 ? left_height : right_height;
        tile.bounds = measure_bounds(tile.tile);
        tile.accuracy = measure_accuracy(tile.tile, tile.flattening.positions, Fabric{});
        tile.verdict = judge(tile.tile, tile.bounds, tile.flattening, tile.accuracy, plan.tolerances);
    }
    EXPECT_EQ(envelope.seams.size(), 1u);
    plan.seams = envelope.seams;
    Seam& seam = plan.seams.front();
    seam.a.parts.resize(static_cast<std::size_t>(sewn_edges));
    seam.b.parts.erase(seam.b.parts.begin(), seam.b.parts.end() - sewn_edges);
    seam.length = testing::length(seam.a);
    plan.walks = walk_seams(plan.tiles, plan.seams, plan.tolerances);
    judge_seams(plan);
    return plan;
}

TEST(JudgeSeams, ASeamWhoseSidesAgreeIsNoFinding) {
    const CutPlan plan = squares(1, 1);
    EXPECT_TRUE(plan.manufacturable());
    EXPECT_THAT(plan.findings, IsEmpty());
}

TEST(JudgeSeams, ASeamBeyondToleranceMakesThePlanUnmanufacturableThoughEachTileIsFine) {
    // Each is off by 0.07 % in opposite directions: every edge is within 0.1 %, the seam is not.
    const CutPlan plan = squares(0.9993, 1.0007);
    EXPECT_TRUE(plan.tiles[0].verdict.manufacturable());
    EXPECT_TRUE(plan.tiles[1].verdict.manufacturable());
    ASSERT_EQ(plan.findings.size(), 1u);
    const Finding& finding = plan.findings.front();
    EXPECT_EQ(finding.code, "seam");
    EXPECT_THAT(finding.message, HasSubstr("the edge of right is 1.40 mm longer than the edge of left"));
    EXPECT_NEAR(finding.value, 1.4, 1e-9);
    EXPECT_NEAR(finding.limit, 1, 1e-9);
    EXPECT_NEAR(finding.at.x(), 1, 1e-12);
    EXPECT_FALSE(plan.manufacturable());
}

TEST(JudgeSeams, AnEdgeOffItsLengthPassesWhereItsMateIsOffAlike) {
    const CutPlan plan = squares(1.004, 1.0044);
    EXPECT_THAT(plan.findings, IsEmpty());
    for (const FlatTile& tile : plan.tiles) {
        // The sewn edge passes. The opposite edge has no mate and keeps its finding, and so does the outline.
        EXPECT_EQ(codes(tile.verdict.waived), std::vector<std::string>{"chain"});
        EXPECT_THAT(codes(tile.verdict.findings), Contains("chain"));
        EXPECT_THAT(codes(tile.verdict.findings), Contains("perimeter"));
    }
}

TEST(JudgeSeams, TheOutlineIsForgivenWithTheEdgesThatMakeItLong) {
    CutPlan plan = squares(1, 1);
    const int sewn_chain = plan.seams[0].a.chain;
    plan.tiles[0].verdict.findings = {{"perimeter", "", Vec3::Zero(), 0.2, 0.1},
                                      {"chain", "", Vec3::Zero(), 0.4, 0.1, sewn_chain}};
    judge_seams(plan);
    EXPECT_THAT(plan.tiles[0].verdict.findings, IsEmpty());
    EXPECT_EQ(plan.tiles[0].verdict.waived.size(), 2u);
    EXPECT_TRUE(plan.manufacturable());
}

TEST(JudgeSeams, AnOutlineTooLongByItselfIsNotForgiven) {
    CutPlan plan = squares(1, 1);
    plan.tiles[0].verdict.findings = {{"perimeter", "", Vec3::Zero(), 0.2, 0.1}};
    judge_seams(plan);
    EXPECT_EQ(codes(plan.tiles[0].verdict.findings), std::vector<std::string>{"perimeter"});
}

TEST(JudgeSeams, AnEdgeWhoseMateDiffersDoesNotPass) {
    const CutPlan plan = squares(1.004, 1);
    EXPECT_EQ(codes(plan.findings), std::vector<std::string>{"seam"});
    EXPECT_THAT(plan.tiles[0].verdict.waived, IsEmpty());
    EXPECT_THAT(codes(plan.tiles[0].verdict.findings), Contains("chain"));
}

TEST(JudgeSeams, AnEdgeSewnOnlyInPartDoesNotPass) {
    const CutPlan plan = squares(1.004, 1.004, 3);
    EXPECT_THAT(plan.findings, IsEmpty());
    EXPECT_THAT(plan.tiles[0].verdict.waived, IsEmpty());
}

TEST(JudgeSeams, ASideThatWasNotFlattenedIsNamed) {
    CutPlan plan = squares(1, 1);
    plan.tiles[1].flattening.positions = Points2();
    plan.walks = walk_seams(plan.tiles, plan.seams, plan.tolerances);
    judge_seams(plan);
    ASSERT_EQ(plan.findings.size(), 1u);
    EXPECT_THAT(plan.findings[0].message, HasSubstr("was not flattened"));
    EXPECT_THAT(plan.findings[0].message, Not(HasSubstr("nan")));
}

}  // namespace judge_seams_test
}  // namespace ripstop
