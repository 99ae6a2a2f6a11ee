#include "ripstop/report/json/report_json.h"

#include <gmock/gmock.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "support/flat_tiles.h"
#include "support/inflated.h"
#include "support/outside.h"
#include "support/seams.h"

namespace ripstop {
namespace report_json_test {

using Json = nlohmann::json;

Json report(const CutPlan& plan) {
    return Json::parse(report_json(plan));
}

TEST(ReportJson, TellsTheInputAndTheTolerancesInRoundFigures) {
    const Json json = report(testing::two_tile_plan());
    EXPECT_EQ(json["input"]["file"], "balloon.obj");
    EXPECT_EQ(json["input"]["unit"], "m");
    EXPECT_EQ(json["tolerances"]["area_pct"], 1);
    EXPECT_EQ(json["tolerances"]["length_pct"], 0.1);
    EXPECT_EQ(json["tolerances"]["strain_pct"], 2);
    EXPECT_EQ(json["fabric"]["roll_width_mm"], 1500);
    EXPECT_THAT(report_json(testing::two_tile_plan()), ::testing::Not(::testing::HasSubstr("00000001")));
}

TEST(ReportJson, SaysTheVerdictInPartsOfSentencesAndTheWarnings) {
    CutPlan plan = testing::two_tile_plan();
    plan.warnings = {"a tile is missing"};
    const Json envelope = Json::parse(report_json(plan, true))["envelope"];
    EXPECT_EQ(envelope["warnings"], Json::array({"a tile is missing"}));
    const Json& says = envelope["says"];
    EXPECT_EQ(says["word"], "Not manufacturable as drawn.");
    EXPECT_EQ(says["headline"], "1 of 2 tiles cannot be made as drawn.");
    ASSERT_FALSE(says["why"].empty());
    EXPECT_EQ(says["why"][0][0], Json({{"tile", plan.tiles[1].tile.name}}));
    EXPECT_THAT(says["why"][0][1].get<std::string>(), ::testing::StartsWith(": length of an edge"));
    EXPECT_EQ(says["codes"]["chain"], "length of an edge");
    EXPECT_EQ(report(testing::two_tile_plan())["envelope"]["warnings"], Json::array());
}

TEST(ReportJson, TellsEachTileInItsUnits) {
    const CutPlan plan = testing::two_tile_plan();
    const Json gore = report(plan)["tiles"][1];
    EXPECT_EQ(gore["name"], "Bílý \"dráček\"");
    EXPECT_EQ(gore["file"], "Bily__dracek_");
    EXPECT_EQ(gore["triangles"], plan.tiles[1].tile.mesh.triangle_count());
    EXPECT_EQ(gore["stop"], "converged");
    EXPECT_EQ(gore["stop_reason"], "energy at rest");
    EXPECT_EQ(gore["seconds"], 0.25);
    EXPECT_EQ(gore["strain"]["warp_min_pct"], -1);
    EXPECT_EQ(gore["strain"]["warp_max_pct"], 0.5);
    EXPECT_EQ(gore["strain"]["shear_max_deg"], 2);
    EXPECT_EQ(gore["energy_j"], 1.5);
    ASSERT_EQ(gore["chains"].size(), plan.tiles[1].tile.chains.size());
    const ChainAccuracy& chain = plan.tiles[1].accuracy.chains[0];
    EXPECT_NEAR(gore["chains"][0]["error_mm"], 1000 * (chain.flat_length - chain.length), 1e-6);
    EXPECT_NEAR(gore["chains"][0]["error_pct"], 100 * chain.error(), 1e-9);
    EXPECT_TRUE(gore["chains"][0]["seam"].is_null());
    EXPECT_EQ(gore["verdict"]["manufacturable"], false);
    EXPECT_EQ(gore["verdict"]["findings"][0]["code"], "chain");
    EXPECT_NEAR(gore["verdict"]["findings"][0]["at_mm"][2], 1000 * plan.tiles[1].verdict.findings[0].at.z(), 1e-6);
}

TEST(ReportJson, TellsTheFabricOfEachTileAndHowMuchThereIsOfEach) {
    CutPlan plan = testing::sewn_plan();
    for (FlatTile& tile : plan.tiles) tile.accuracy.area = 2;
    plan.tiles[1].tile.fabric = Fabric{};
    plan.tiles[1].tile.fabric->name = "silk";
    const Json json = report(plan);
    EXPECT_EQ(json["fabric"]["name"], "isotropic");
    ASSERT_EQ(json["fabrics"].size(), 2U);
    EXPECT_EQ(json["fabrics"][0]["name"], "isotropic");
    EXPECT_EQ(json["fabrics"][0]["tiles"], 2);
    EXPECT_EQ(json["fabrics"][0]["area_m2"], 4);
    EXPECT_EQ(json["fabrics"][1]["name"], "silk");
    EXPECT_EQ(json["fabrics"][1]["area_m2"], 2);
    EXPECT_EQ(json["tiles"][0]["fabric"], "isotropic");
    EXPECT_EQ(json["tiles"][1]["fabric"], "silk");
}

TEST(ReportJson, TellsHowSeamsAreSewnAndFreeEdgesFinished) {
    CutPlan plan = testing::sewn_plan();
    plan.seams[1].type = {"plain", 0.013, 1, false};
    for (FlatTile& tile : plan.tiles) tile.accuracy.chains.resize(4, {1, 1});
    const Json json = report(plan);
    EXPECT_EQ(json["seams"][0]["type"], "flat-felled");
    EXPECT_EQ(json["seams"][0]["allowance_a_mm"], 25);
    EXPECT_EQ(json["seams"][1]["type"], "plain");
    EXPECT_EQ(json["seams"][1]["allowance_b_mm"], 13);
    const Json& left = json["tiles"][0]["chains"];
    EXPECT_EQ(left[0]["type"], "hem");
    EXPECT_EQ(left[0]["free_mm"], 1000);
    EXPECT_FALSE(left[1].contains("type")) << "seams hold all of it";
    EXPECT_EQ(json["seam_types"], Json::parse(R"([
        {"type": "flat-felled", "allowance_mm": 25.0, "rows": 2, "tape": false, "seams": 2, "free_edges": 0, "length_mm": 2000.0},
        {"type": "plain", "allowance_mm": 13.0, "rows": 1, "tape": false, "seams": 1, "free_edges": 0, "length_mm": 1000.0},
        {"type": "hem", "allowance_mm": 25.0, "rows": 2, "tape": false, "seams": 0, "free_edges": 7, "length_mm": 8000.0}])"));
}

TEST(ReportJson, SumsUpTheEnvelope) {
    const CutPlan plan = testing::two_tile_plan();
    const Json json = report(plan);
    EXPECT_EQ(json["envelope"]["tiles"], 2);
    EXPECT_EQ(json["envelope"]["manufacturable"], false);
    EXPECT_EQ(json["envelope"]["failed"], Json::array({"Bílý \"dráček\""}));
    EXPECT_NEAR(json["envelope"]["area_m2"], plan.area(), 1e-9);
    EXPECT_TRUE(json["seams"].is_array());
}

TEST(ReportJson, TellsEachSeamInItsUnits) {
    const CutPlan plan = testing::sewn_plan();
    const Json json = report(plan);
    ASSERT_EQ(json["seams"].size(), 3u);
    const Json& seam = json["seams"][1];
    EXPECT_EQ(seam["id"], "S2");
    EXPECT_EQ(seam["tile_a"], "left");
    EXPECT_EQ(seam["tile_b"], "high");
    EXPECT_EQ(seam["chain_a"], 2);
    EXPECT_EQ(seam["chain_b"], 4);
    EXPECT_NEAR(seam["length_mm"], 1000, 1e-9);
    EXPECT_NEAR(seam["flat_b_mm"], 1002, 1e-9);
    EXPECT_NEAR(seam["mismatch_mm"], 2, 1e-9);
    EXPECT_NEAR(seam["mismatch_pct"], 0.2, 1e-9);
    EXPECT_NEAR(seam["drift_max_mm"], 2, 1e-9);
    EXPECT_NEAR(seam["drift_max_at_mm"], 1000, 1e-9);
    EXPECT_NEAR(seam["limit_mm"], 1, 1e-9);
    EXPECT_EQ(seam["ok"], false);
    ASSERT_EQ(seam["notches"].size(), 3u);
    EXPECT_NEAR(seam["notches"][1]["at_mm"], 500, 1e-9);
    EXPECT_NEAR(seam["notches"][1]["drift_mm"], 1, 1e-9);
    EXPECT_EQ(json["seams"][0]["ok"], true);
    EXPECT_EQ(json["envelope"]["seams"], 3);
    EXPECT_EQ(json["envelope"]["failed_seams"], Json::array({"S2"}));
    EXPECT_EQ(json["envelope"]["findings"][0]["code"], "seam");
    EXPECT_EQ(json["envelope"]["manufacturable"], false);
    EXPECT_EQ(json["envelope"]["failed"], Json::array()) << "no tile has failed";
}

TEST(ReportJson, TellsWhatEachChainIsSewnIn) {
    CutPlan plan = testing::sewn_plan();
    for (FlatTile& tile : plan.tiles) tile.accuracy.chains.resize(4, {1, 1});
    const Json left = report(plan)["tiles"][0]["chains"];
    EXPECT_EQ(left[1]["seam"], "S1");
    EXPECT_EQ(left[1]["seams"], Json::array({"S1", "S2"})) << "from the bottom up, as the boundary runs";
    EXPECT_TRUE(left[0]["seam"].is_null());
    EXPECT_FALSE(left[0].contains("seams"));
    const Json high = report(plan)["tiles"][2]["chains"];
    EXPECT_EQ(high[0]["seam"], "S3");
    EXPECT_EQ(high[3]["seam"], "S2");
}

TEST(ReportJson, TellsWhatWasWaived) {
    CutPlan plan = testing::two_tile_plan();
    EXPECT_FALSE(report(plan)["tiles"][1]["verdict"].contains("waived"));
    std::swap(plan.tiles[1].verdict.findings, plan.tiles[1].verdict.waived);
    EXPECT_EQ(report(plan)["tiles"][1]["verdict"]["waived"][0]["code"], "chain");
    EXPECT_EQ(report(plan)["tiles"][1]["verdict"]["manufacturable"], true);
}

TEST(ReportJson, WritesNullForWhatIsNotFinite) {
    CutPlan plan = testing::two_tile_plan();
    plan.tiles[0].accuracy.energy = std::numeric_limits<double>::infinity();
    plan.tiles[0].accuracy.chains[0].length = 0;
    plan.tiles[0].accuracy.chains[0].flat_length = 0;
    const Json tile = report(plan)["tiles"][0];
    EXPECT_TRUE(tile["energy_j"].is_null());
    EXPECT_TRUE(tile["chains"][0]["error_pct"].is_null());
}

TEST(ReportJson, LeavesTheSecondsOutWhereItMustBeReproducible) {
    CutPlan plan = testing::two_tile_plan();
    const std::string first = report_json(plan, true);
    plan.tiles[0].seconds = 99;
    EXPECT_EQ(report_json(plan, true), first);
    EXPECT_NE(report_json(plan), first);
    EXPECT_THAT(first, ::testing::Not(::testing::HasSubstr("\"seconds\"")));
}

TEST(ReportJson, SurvivesANameThatIsNoUtf8) {
    CutPlan plan = testing::two_tile_plan();
    plan.tiles[0].tile.name = "tile \xff";
    EXPECT_EQ(report(plan)["tiles"][0]["name"], "tile \xEF\xBF\xBD");
}

/// The errors that python3-jsonschema finds in each of the reports, one per line: `NUMBER: message`.
std::string schema_errors(const std::string& python, const std::vector<Json>& reports) {
    const testing::ScratchDirectory scratch;
    testing::write_text(scratch.path("reports.json"), Json(reports).dump());
    testing::write_text(scratch.path("validate.py"), R"(import json, sys, jsonschema
schema, reports = (json.load(open(name)) for name in sys.argv[1:])
jsonschema.Draft202012Validator.check_schema(schema)
for number, report in enumerate(reports):
    for error in jsonschema.Draft202012Validator(schema).iter_errors(report): print(number, error.message, sep=': ')
)");
    return testing::run_command(python + " " + scratch.path("validate.py") +
                                " " RIPSTOP_SOURCE_DIR "/docs/report.schema.json " + scratch.path("reports.json"))
        .output;
}

TEST(ReportSchema, HoldsForWhatIsWrittenAndOnlyForThat) {
    const std::string python = testing::python_with("jsonschema");
    if (python.empty()) GTEST_SKIP() << "no Python with jsonschema here";
    CutPlan plan = testing::two_tile_plan();
    const Json written = report(plan), reproducible = Json::parse(report_json(plan, true));
    plan.tiles[0].accuracy.energy = std::numeric_limits<double>::infinity();
    plan.tiles[0].flattening = {};
    const Json failed = report(plan);
    CutPlan inflated = testing::inflated_plan();
    const Json flown = report(inflated), flown_reproducible = Json::parse(report_json(inflated, true));
    inflated.rounds = {{"as drawn", {}, 10, 400, 0, true}};
    inflated.inflated->sensitivity = {{"cloth 20 % softer", {}, 10, 400}};
    EXPECT_EQ(schema_errors(python, {written, reproducible, failed, report(CutPlan{}), report(testing::sewn_plan()),
                                     flown, flown_reproducible, report(inflated)}),
              "");
    Json without = written, more = written, text = written;
    without["tiles"][1].erase("perimeter_error_pct");
    more["tiles"][1]["colour"] = "red";
    text["envelope"]["area_m2"] = "5";
    const std::string errors = schema_errors(python, {without, more, text});
    EXPECT_THAT(errors, ::testing::HasSubstr("0: 'perimeter_error_pct' is a required property"));
    EXPECT_THAT(errors, ::testing::HasSubstr("1: Additional properties are not allowed ('colour' was unexpected)"));
    EXPECT_THAT(errors, ::testing::HasSubstr("2: '5' is not of type"));
}

}  // namespace report_json_test
}  // namespace ripstop
