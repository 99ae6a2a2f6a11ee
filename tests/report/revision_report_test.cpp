#include "ripstop/report/words/revision_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/outside.h"

namespace ripstop {
namespace revision_report_test {

using ::testing::HasSubstr;
using Json = nlohmann::json;

std::vector<PieceChange> three_changes() {
    PieceChange changed{"G01P02"};
    changed.area_before = 2;
    changed.area_after = 2.0012;
    changed.perimeter_before = 6;
    changed.perimeter_after = 6.0035;
    changed.distance = 0.0021;
    changed.distance_fitted = 0.0019;
    changed.grain_turn = -0.0174532925199433;
    changed.edges_before = changed.edges_after = 4;
    EdgeChange edge{1, 1.5, 1.5035, 0.025, 0.03, "flat-felled", "taped", 2, 2};
    edge.notch_moved = 0.001;
    edge.edge_after = 3;
    edge.notch_depth_before = 0.005;
    edge.notch_depth_after = 0.008;
    edge.doubles_after = 1;
    edge.mates_before = {{"G01P01", 1.5}};
    changed.edges = {edge};
    changed.fields = {{"colour", "red", "blue"}};
    changed.lines = {{"tape", LineChange::Kind::moved, 0.2}, {"logo", LineChange::Kind::gone}};
    changed.sew_distance_fitted = 0.0123;
    return {{"G01P01", PieceChange::Kind::gone}, changed, {"G09P09", PieceChange::Kind::added}};
}

std::vector<SeamTypeChange> one_type() {
    return {{"flat-felled", {{"rows", "2", "3"}}}};
}

TEST(RevisionText, SaysWhatChangedInMillimetres) {
    const std::string text = revision_text(three_changes());
    EXPECT_THAT(text, HasSubstr("G01P01  gone"));
    EXPECT_THAT(text, HasSubstr("+12.00"));  // cm²
    EXPECT_THAT(text, HasSubstr("+3.50"));
    EXPECT_THAT(text, HasSubstr("-1.000"));  // degrees
    EXPECT_THAT(
        text,
        HasSubstr("G01P02 edge 2 (now 4): 1500.00 to 1503.50 mm (+3.50), flat-felled to taped, allowance 25.00 to "
                  "30.00 mm, notches moved by up to 1.00 mm, notches 5.00 to 8.00 mm deep, 0 to 1 double notches, "
                  "sewn to G01P01 (1500.00 mm), now to nothing\n"));
    EXPECT_THAT(text, HasSubstr("12.30"));  // the sew line
    EXPECT_THAT(text, HasSubstr("G01P02: line \"tape\" moved by up to 200.00 mm\n"));
    EXPECT_THAT(text, HasSubstr("G01P02: line \"logo\" gone\n"));
    EXPECT_THAT(revision_text({}, one_type()), HasSubstr("seam type flat-felled: rows 2 to 3\n"));
    EXPECT_THAT(text, HasSubstr("G01P02: colour \"red\" to \"blue\"\n"));
    EXPECT_EQ(revision_text({}), "No piece changed.\n");
}

TEST(RevisionJson, HoldsTheFigures) {
    const Json json = Json::parse(revision_json(three_changes(), one_type(), "a", "b"));
    EXPECT_FALSE(json["same"]);
    ASSERT_EQ(json["pieces"].size(), 3u);
    EXPECT_EQ(json["pieces"][0]["change"], "gone");
    EXPECT_EQ(json["pieces"][1]["distance_fitted_mm"], 1.9);
    EXPECT_EQ(json["pieces"][1]["edges"][0]["edge"], 2);
    EXPECT_EQ(json["pieces"][1]["edges"][0]["length_after_mm"], 1503.5);
    EXPECT_EQ(json["pieces"][1]["edges"][0]["mates_before"][0]["piece"], "G01P01");
    EXPECT_EQ(json["pieces"][1]["lines"][0]["distance_mm"], 200);
    EXPECT_TRUE(Json::parse(revision_json({}, {}, "a", "b"))["same"]);
    EXPECT_FALSE(Json::parse(revision_json({}, one_type(), "a", "b"))["same"]);
}

TEST(RevisionSchema, HoldsForWhatIsWritten) {
    const std::string python = testing::python_with("jsonschema");
    if (python.empty()) GTEST_SKIP() << "no Python with jsonschema here";
    const testing::ScratchDirectory scratch;
    testing::write_text(scratch.path("diff.json"), revision_json(three_changes(), one_type(), "a", "b"));
    testing::write_text(scratch.path("validate.py"), R"(import json, sys, jsonschema
schema, diff = (json.load(open(name)) for name in sys.argv[1:])
jsonschema.Draft202012Validator.check_schema(schema)
for error in jsonschema.Draft202012Validator(schema).iter_errors(diff): print(error.message)
)");
    EXPECT_EQ(testing::run_command(python + " " + scratch.path("validate.py") +
                                   " " RIPSTOP_SOURCE_DIR "/docs/diff.schema.json " + scratch.path("diff.json"))
                  .output,
              "");
}

}  // namespace revision_report_test
}  // namespace ripstop
