/// `ripstop check` on the command line.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "ripstop/design/natural/gores.h"
#include "support/program.h"

namespace ripstop {
namespace check_test {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::ProgramRun;
using testing::Workshop;
using Json = nlohmann::json;

std::vector<NamedMesh> balloon() {
    EnvelopeDesign design;
    design.gores = 12;
    design.panels = 4;
    design.volume = 600;
    design.edge_length = 0.5;
    return design_natural(design);
}

TEST(CheckCommand, SaysWhatItUnderstoodAndThatItIsSound) {
    const Workshop workshop;
    workshop.write_tiles("envelope.obj", balloon());
    const ProgramRun run = workshop.ripstop("check envelope.obj --unit m");
    EXPECT_EQ(run.code, 0) << run.out;
    EXPECT_THAT(run.err, IsEmpty());
    EXPECT_THAT(run.out, HasSubstr("envelope.obj, in m\n"));
    EXPECT_THAT(run.out, HasSubstr("tiles          48, "));
    EXPECT_THAT(run.out, HasSubstr("seams          84, "));
    EXPECT_THAT(run.out, HasSubstr("Sound: nothing is wrong with this envelope."));
    EXPECT_THAT(workshop.ripstop("check envelope.obj").out, HasSubstr("in m (assumed; --unit changes it)"));
    EXPECT_THAT(workshop.ripstop("check envelope.obj --quiet").out, IsEmpty());
}

TEST(CheckCommand, EndsWith1AndASentenceWhereSomethingIsWrong) {
    const Workshop workshop;
    std::vector<NamedMesh> tiles = balloon();
    tiles[17].mesh.positions.rowwise() += Vec3(0.03, 0, 0.04).transpose();
    workshop.write_tiles("envelope.obj", tiles);
    const ProgramRun run = workshop.ripstop("check envelope.obj --unit m");
    EXPECT_EQ(run.code, 1);
    EXPECT_THAT(run.out, HasSubstr("WRONG          tile G05P02 at "));
    EXPECT_THAT(run.out, HasSubstr(" lies 50.0 mm away from its place"));
    EXPECT_THAT(run.out, HasSubstr("One thing is wrong with this envelope.\n"));
    const ProgramRun json = workshop.ripstop("check envelope.obj --unit m --json");
    EXPECT_EQ(json.code, 1);
    const Json report = Json::parse(json.out);
    EXPECT_FALSE(report["sound"]);
    ASSERT_EQ(report["issues"].size(), 1u);
    EXPECT_EQ(report["issues"][0]["code"], "shifted");
    EXPECT_EQ(report["issues"][0]["tiles"], Json::array({"G05P02"}));
    EXPECT_NEAR(report["issues"][0]["distance_mm"], 50, 0.5);
}

TEST(CheckCommand, ProposesTheUnit) {
    const Workshop workshop;
    workshop.write_tiles("envelope.obj", balloon(), 1000);
    const ProgramRun run = workshop.ripstop("check envelope.obj");
    EXPECT_EQ(run.code, 1);
    EXPECT_THAT(run.out, HasSubstr("m, a hot-air balloon is 5 to 60 m tall; with --unit mm it would measure "));
    EXPECT_EQ(workshop.ripstop("check envelope.obj --unit mm").code, 0);
}

TEST(CheckCommand, TakesTheSeamToleranceWithItsUnit) {
    const Workshop workshop;
    std::vector<NamedMesh> tiles = balloon();
    for (std::size_t t = 0; t < tiles.size(); ++t)
        if (t % 4 > 1) tiles[t].mesh.positions.col(2).array() += 0.001;
    workshop.write_tiles("envelope.obj", tiles);
    EXPECT_EQ(workshop.ripstop("check envelope.obj --unit m").code, 1);
    EXPECT_EQ(workshop.ripstop("check envelope.obj --unit m --seam-tolerance 1.5mm").code, 0);
    workshop.write("project.json", R"({"unit": "m", "seam_tolerance_mm": 1.5})");
    EXPECT_EQ(workshop.ripstop("check envelope.obj --project project.json").code, 0);
    EXPECT_EQ(workshop.ripstop("check envelope.obj --project project.json --seam-tolerance 0.5mm").code, 1);
    const ProgramRun bare = workshop.ripstop("check envelope.obj --seam-tolerance 1");
    EXPECT_EQ(bare.code, 3);
    EXPECT_THAT(bare.err, HasSubstr("--seam-tolerance"));
}

TEST(CheckCommand, EndsWith3ForASurfaceThatIsNoTile) {
    const Workshop workshop;
    workshop.write("bad.obj", "o b\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n");
    const ProgramRun run = workshop.ripstop("check bad.obj");
    EXPECT_EQ(run.code, 3);
    EXPECT_THAT(run.err, HasSubstr("b: "));
    EXPECT_THAT(run.out, IsEmpty());
}

TEST(CheckCommand, WritesJsonThatItsSchemaAccepts) {
    const std::string python = testing::python_with("jsonschema");
    if (python.empty()) GTEST_SKIP() << "no Python with jsonschema here";
    const Workshop workshop;
    std::vector<NamedMesh> tiles = balloon();
    workshop.write_tiles("sound.obj", tiles);
    tiles[9].mesh.triangles.col(0).swap(tiles[9].mesh.triangles.col(1));
    tiles.erase(tiles.begin() + 30);
    workshop.write_tiles("broken.obj", tiles, 1000);
    workshop.write_tiles("small.obj", balloon());
    workshop.write("validate.py",
                   "import json, sys, jsonschema\n"
                   "schema, *reports = (json.load(open(name)) for name in sys.argv[1:])\n"
                   "jsonschema.Draft202012Validator.check_schema(schema)\n"
                   "for report in reports: jsonschema.Draft202012Validator(schema).validate(report)\n");
    workshop.write("sound.json", workshop.ripstop("check sound.obj --json --unit m").out);
    workshop.write("broken.json", workshop.ripstop("check broken.obj --json --unit m").out);
    workshop.write("small.json", workshop.ripstop("check small.obj --json --unit mm").out);
    const auto result = testing::run_command(
        python + " " + workshop.path("validate.py") + " " RIPSTOP_SOURCE_DIR "/docs/check.schema.json " +
        workshop.path("sound.json") + " " + workshop.path("broken.json") + " " + workshop.path("small.json"));
    EXPECT_TRUE(Json::parse(workshop.ripstop("check small.obj --json --unit mm").out)["seams"].is_null());
    EXPECT_EQ(result.code, 0) << result.output;
}

TEST(CheckCommand, ShowsAnExample) {
    const Workshop workshop;
    EXPECT_THAT(workshop.ripstop("check --help").out, HasSubstr("Examples:\n  ripstop check envelope.obj"));
}

}  // namespace check_test
}  // namespace ripstop
