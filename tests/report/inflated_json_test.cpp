#include "ripstop/report/json/inflated_json.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "ripstop/report/json/report_json.h"
#include "support/inflated.h"

namespace ripstop {
namespace inflated_json_test {

using Json = nlohmann::json;

Json report(const CutPlan& plan) {
    return Json::parse(report_json(plan));
}

TEST(InflatedJson, HoldsWhatTheContractPromisesFirstAndInItsUnits) {
    const auto json = inflated_json(testing::inflated_plan(), false);
    std::vector<std::string> keys;
    for (const auto& [key, value] : json.items()) keys.push_back(key);
    keys.resize(14);
    EXPECT_THAT(
        keys, ::testing::ElementsAre("deviation_rms_mm", "deviation_max_mm", "height_mm", "drawn_height_mm",
                                     "volume_m3", "drawn_volume_m3", "lift_n", "stress_max_n_per_m", "tape_force_max_n",
                                     "wrinkled_pct", "safety_factor", "converged", "iterations", "seconds"));
    EXPECT_EQ(json["deviation_rms_mm"], 10);
    EXPECT_EQ(json["deviation_max_mm"], -20);
    EXPECT_EQ(json["height_mm"], 10050);
    EXPECT_EQ(json["drawn_volume_m3"], 400);
    EXPECT_EQ(json["stress_max_n_per_m"], 20.4);
    EXPECT_EQ(json["tape_force_max_n"], 150);
    EXPECT_EQ(json["wrinkled_pct"], 5);
    EXPECT_EQ(json["safety_factor"], 7.1) << "the least, whatever is asked of it";
    EXPECT_EQ(json["converged"], true);
    EXPECT_EQ(json["iterations"], 17);
    EXPECT_EQ(json["deviation_limit_mm"], 30) << "0.3 % of 10 m";
}

TEST(InflatedJson, LeavesTheSecondsOutWhereItMustBeReproducible) {
    EXPECT_TRUE(inflated_json(testing::inflated_plan(), false).contains("seconds"));
    EXPECT_FALSE(inflated_json(testing::inflated_plan(), true).contains("seconds"));
}

TEST(InflatedJson, TellsThreadsBySharesOfTheirLength) {
    const Json json = report(testing::inflated_plan());
    for (const Json& place : {json["inflated"], json["tiles"][1]["inflated"]}) {
        EXPECT_NEAR(place["strain"]["warp_max_pct"], 1, 1e-9) << "not the Green strain, 1.005";
        EXPECT_EQ(place["strain"]["warp_min_pct"], 0);
        EXPECT_EQ(place["strain"]["weft_max_pct"], 0);
        EXPECT_EQ(place["stress"]["warp_max_n_per_m"], 20);
        EXPECT_EQ(place["stress"]["weft_max_n_per_m"], 5);
    }
}

TEST(InflatedJson, TellsTheAngleBetweenTheThreadsOfAShear) {
    CutPlan plan = testing::inflated_plan();  // F = [1 tan g; 0 1]: the weft turns by g and becomes 1/cos g long
    const double g = 0.1, t = std::tan(g);
    plan.inflated->tiles[0].strain.row(0) = Vec3(0, 0.5 * t * t, t);
    const Json strain = report(plan)["tiles"][0]["inflated"]["strain"];
    EXPECT_NEAR(strain["shear_max_deg"], g * 180 / std::numbers::pi, 1e-9);
    EXPECT_NEAR(strain["weft_max_pct"], 100 * (1 / std::cos(g) - 1), 1e-9);
}

TEST(InflatedJson, NamesTapesByWhatTheyBelongTo) {
    const Json tapes = report(testing::inflated_plan())["inflated"]["tapes"];
    ASSERT_EQ(tapes.size(), 3u);
    EXPECT_EQ(tapes[0]["kind"], "load");
    EXPECT_EQ(tapes[0]["seam"], "S1");
    EXPECT_EQ(tapes[0]["force_min_n"], 90);
    EXPECT_EQ(tapes[0]["force_max_at_mm"], Json::array({1000.0, 500.0, 10.0}));
    EXPECT_EQ(tapes[1]["kind"], "wire");
    EXPECT_EQ(tapes[1]["number"], 1);
    EXPECT_EQ(tapes[2]["kind"], "tie");
    EXPECT_EQ(tapes[2]["number"], 2);
}

TEST(InflatedJson, GivesLoadsOfClothByTheMetre) {
    const Json safety = report(testing::inflated_plan())["inflated"]["safety"];
    EXPECT_EQ(safety[0]["load_n_per_m"], 20.4);
    EXPECT_FALSE(safety[0].contains("load_n"));
    EXPECT_EQ(safety[1]["load_n"], 150);
    EXPECT_EQ(safety[1]["strength_n"], 10000);
    EXPECT_EQ(safety[2]["required"], 2.25);
    EXPECT_EQ(safety[2]["ok"], true);
}

TEST(InflatedJson, HoldsRoundsCausesAndSensitivity) {
    CutPlan plan = testing::inflated_plan();
    plan.rounds = {{"as drawn", {0.02, 0.03, 0.025, 0.04}, 10.1, 410, 0, false},
                   {"displacement", {0.01, -0.02, 0.012, 0.025}, 10.05, 404, 0.7, true}};
    plan.inflated->sensitivity = {{"cloth 20 % stiffer", {0.011, 0.02, 0.013, 0.03}, 10.06, 405}};
    plan.inflated->causes->patterns = std::numeric_limits<double>::quiet_NaN();
    const Json json = report(plan)["inflated"];
    EXPECT_EQ(json["rounds"][1]["step"], "displacement");
    EXPECT_EQ(json["rounds"][1]["deviation_max_mm"], -20);
    EXPECT_EQ(json["rounds"][1]["best"], true);
    EXPECT_EQ(json["sensitivity"][0]["moved_rms_mm"], 13);
    EXPECT_EQ(json["causes"]["shape_mm"], 1);
    EXPECT_TRUE(json["causes"]["patterns_mm"].is_null());
    EXPECT_EQ(json["compensated"], true);
    plan.inflated->causes.reset();
    EXPECT_FALSE(report(plan)["inflated"].contains("causes"));
}

TEST(InflatedJson, HasNoLeastFactorWhereNothingWasJudged) {
    CutPlan plan = testing::inflated_plan();
    plan.inflated->safety.clear();
    EXPECT_TRUE(report(plan)["inflated"]["safety_factor"].is_null());
}

TEST(InflatedJson, IsNotThereBeforeAPlanIsInflated) {
    CutPlan plan = testing::inflated_plan();
    plan.inflated.reset();
    const Json json = report(plan);
    EXPECT_FALSE(json.contains("inflated"));
    EXPECT_FALSE(json["tiles"][0].contains("inflated"));
    EXPECT_FALSE(json["seams"][0].contains("tape_cut_mm"));
}

}  // namespace inflated_json_test
}  // namespace ripstop
