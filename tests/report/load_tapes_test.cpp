#include "ripstop/report/figures/load_tapes.h"

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "ripstop/report/json/report_json.h"
#include "support/inflated.h"
#include "support/seams.h"

namespace ripstop {
namespace load_tapes_test {

TEST(LoadTapes, AreCutByTheSeamTheFactorAndTheForeshortening) {
    CutPlan plan = testing::inflated_plan();
    plan.seams[2].type.tape = true;
    std::vector<double> lengths = tape_cut_lengths(plan);
    EXPECT_NEAR(lengths[0], 0.99 * plan.seams[0].length, 1e-12);
    EXPECT_TRUE(std::isnan(lengths[1])) << "takes none";
    EXPECT_NEAR(lengths[2], 0.99 * plan.seams[2].length, 1e-12) << "as much shorter as the one that was inflated";
    plan.tape_factors = {0.9, 1, 1.1};
    plan.inflated.reset();
    lengths = tape_cut_lengths(plan);
    EXPECT_NEAR(lengths[0], 0.9 * plan.seams[0].length, 1e-12);
    EXPECT_NEAR(lengths[2], 1.1 * plan.seams[2].length, 1e-12);
    plan.tape_factors.clear();
    EXPECT_TRUE(std::isnan(tape_cut_lengths(plan)[0])) << "nothing is known of tapes";
}

/// Four copies of the inflated plan about an axis that is not the origin; only the first has its own tapes, on S1
/// and S3.
CutPlan four_sectors() {
    const CutPlan one = testing::inflated_plan();
    CutPlan plan = one;
    plan.tiles.clear();
    plan.seams.clear();
    plan.inflated->sectors = 4;
    for (int turn = 0; turn < 4; ++turn) {
        const double angle = turn * std::numbers::pi / 2;
        const Eigen::Matrix3d rotation = Eigen::AngleAxisd(angle, Vec3::UnitZ()).toRotationMatrix();
        for (FlatTile tile : one.tiles) {
            Points3& points = tile.tile.mesh.positions;
            for (Eigen::Index v = 0; v < points.rows(); ++v)
                points.row(v) = rotation * (Vec3(points.row(v)) + Vec3(3, 1, 0)) + Vec3(100, -20, 5);
            plan.tiles.push_back(tile);
        }
        for (Seam seam : one.seams) {
            seam.a.tile += 3 * turn;
            seam.b.tile += 3 * turn;
            seam.type.tape = seam.id != "S2";
            plan.seams.push_back(seam);
        }
    }
    plan.inflated->tapes.push_back({TapeKind::load, 2, 70, 60, 1, Vec3::Zero()});
    return plan;
}

TEST(LoadTapes, OfOneSectorStandForThoseOfAllOthers) {
    const std::vector<int> tapes = tapes_of_seams(four_sectors());
    EXPECT_THAT(tapes, ::testing::ElementsAre(0, -1, 3, 0, -1, 3, 0, -1, 3, 0, -1, 3));
}

TEST(LoadTapes, AreTheirOwnSeamsAloneWhereThereIsNoSymmetry) {
    CutPlan plan = four_sectors();
    plan.inflated->sectors = 1;
    EXPECT_THAT(tapes_of_seams(plan), ::testing::ElementsAre(0, -1, 3, -1, -1, -1, -1, -1, -1, -1, -1, -1));
}

TEST(LoadTapes, StandWithTheirSeamsInTheReport) {
    const auto seams = nlohmann::json::parse(report_json(testing::inflated_plan()))["seams"];
    EXPECT_NEAR(seams[0]["tape_cut_mm"], 990, 1e-9);
    EXPECT_EQ(seams[0]["tape_force_max_n"], 150);
    EXPECT_FALSE(seams[1].contains("tape_cut_mm"));
    EXPECT_FALSE(seams[1].contains("tape_force_max_n"));
}

}  // namespace load_tapes_test
}  // namespace ripstop
