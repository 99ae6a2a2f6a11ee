/// The project file on the command line.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "ripstop/design/natural/gores.h"
#include "support/program.h"

namespace ripstop {
namespace project_test {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using testing::ProgramRun;
using testing::Workshop;
using Json = nlohmann::json;

std::vector<NamedMesh> balloon() {
    return design_natural({.gores = 12, .panels = 4, .volume = 600, .edge_length = 0.5});
}

/// The first JSON block in docs/project.md.
std::string project_of_the_docs() {
    std::ifstream in(RIPSTOP_SOURCE_DIR "/docs/project.md");
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    const std::size_t start = text.find("```json\n") + 8;
    return text.substr(start, text.find("```", start) - start);
}

const Json& tile_named(const Json& report, const std::string& name) {
    for (const Json& tile : report["tiles"])
        if (tile["name"] == name) return tile;
    throw std::runtime_error("no tile " + name);
}

TEST(ProjectFile, OfTheDocsIsTakenAsItSays) {
    const Workshop workshop;
    workshop.write_tiles("envelope.obj", balloon());
    workshop.write("shop.json", project_of_the_docs());
    const ProgramRun run =
        workshop.ripstop("flatten envelope.obj --project shop.json --propose none -o plan --json --quiet");
    ASSERT_LE(run.code, 1) << run.err;
    EXPECT_THAT(run.err, IsEmpty()) << "every entry fits something";
    const Json report = Json::parse(run.out);
    EXPECT_EQ(report["fabric"]["name"], "nylon");
    ASSERT_EQ(report["fabrics"].size(), 2U);
    EXPECT_EQ(report["fabrics"][0]["tiles"], 36);
    EXPECT_EQ(report["fabrics"][1]["name"], "nylon-silicone");
    EXPECT_EQ(report["fabrics"][1]["tiles"], 12);
    EXPECT_EQ(tile_named(report, "G03P04")["fabric"], "nylon-silicone");
    EXPECT_EQ(tile_named(report, "G03P03")["fabric"], "nylon");
    EXPECT_EQ(tile_named(report, "G03P03")["grain"]["source"], "shop.json, tile \"G*\"");
    EXPECT_EQ(tile_named(report, "G03P04")["grain"]["source"], "longest axis");
    int felled = 0, taped = 0;
    for (const Json& seam : report["seams"]) {
        const bool top =
            seam["tile_a"].get<std::string>().ends_with("P04") != seam["tile_b"].get<std::string>().ends_with("P04");
        EXPECT_EQ(seam["allowance_b_mm"], top ? 30 : 25) << seam["id"];
        felled += seam["type"] == "flat-felled";
        taped += seam["type"] == "taped";
    }
    EXPECT_GE(felled, 36) << "between the panels of a gore";
    EXPECT_GE(taped, 36) << "between the gores";
    int hems = 0;
    for (const Json& tile : report["tiles"])
        for (const Json& chain : tile["chains"]) {
            if (!chain["seam"].is_null()) continue;
            ++hems;
            const bool mouth = tile["name"].get<std::string>().ends_with("P01");
            EXPECT_EQ(chain["type"], mouth ? "mouth-hem" : "hem");
            EXPECT_EQ(chain["allowance_mm"], mouth ? 38 : 25);
            EXPECT_NEAR(chain["free_mm"].get<double>(), chain["length_mm"].get<double>(), 1e-6) << "summed twice";
        }
    EXPECT_EQ(hems, 24);
    EXPECT_THAT(workshop.read("plan/seams.csv"), HasSubstr(",ok,type,allowance_a_mm,allowance_b_mm"));
    EXPECT_THAT(workshop.read("plan/seams.csv"), HasSubstr(",true,taped,25"));
    EXPECT_THAT(workshop.read("plan/tiles.csv"), HasSubstr(",nylon-silicone\n"));
}

TEST(ProjectFile, FabricOfTheCommandLineGoesBeforeTheProjectsAlone) {
    const Workshop workshop;
    workshop.write_tiles("envelope.obj", {testing::flat_tile("a"), testing::bent_tile("b")});
    workshop.write("shop.json", R"({"fabric": "nylon", "tiles": [{"name": "b", "fabric": "nylon-silicone"}]})");
    const Json report = Json::parse(
        workshop.ripstop("flatten envelope.obj --project shop.json --fabric polyester -o plan --json --quiet").out);
    EXPECT_EQ(report["fabric"]["name"], "polyester");
    EXPECT_EQ(tile_named(report, "a")["fabric"], "polyester");
    EXPECT_EQ(tile_named(report, "b")["fabric"], "nylon-silicone");
}

TEST(ProjectFile, NamesTilesBeforeAnythingElseLooksAtNames) {
    const Workshop workshop;
    NamedMesh beside = testing::flat_tile("envelope_2");
    beside.mesh.positions.col(0).array() += 2;
    workshop.write_tiles("mm.obj", {testing::flat_tile("envelope_1"), beside}, 1000);
    workshop.write("shop.json", R"({"unit": "mm", "tiles": [{"name": "G01P01", "source": "envelope_2"},
        {"name": "G02P01", "at": [500, 500, 0]}, {"name": "G*", "fabric": "nylon"}],
        "seams": [{"between": ["G01P01", "G02P01"], "type": "french"}]})");
    const Json report =
        Json::parse(workshop.ripstop("flatten mm.obj --project shop.json --tile 'G01*' -o plan --json --quiet").out);
    ASSERT_EQ(report["tiles"].size(), 1U);
    EXPECT_EQ(report["tiles"][0]["name"], "G01P01");
    EXPECT_EQ(report["tiles"][0]["fabric"], "nylon");
    EXPECT_THAT(workshop.ripstop("check mm.obj --project shop.json").out, HasSubstr("sewn           french 1 (25 mm)"));
    workshop.write("shop.json", R"({"unit": "mm", "tiles": [{"name": "G01P01", "source": "envelope_9"}]})");
    const ProgramRun run = workshop.ripstop("flatten mm.obj --project shop.json -o other");
    EXPECT_EQ(run.code, 3);
    EXPECT_THAT(run.err, HasSubstr("shop.json: tile \"G01P01\": no surface of the file is called \"envelope_9\""));
}

TEST(ProjectFile, IsCheckedAgainstTheInput) {
    const Workshop workshop;
    workshop.write_tiles("envelope.obj", balloon());
    workshop.write("shop.json", R"({"unit": "m", "fabric": "nylon", "tiles": [{"name": "H*"},
        {"name": "G*P04", "fabric": "polyester"}], "seams": [{"free": "*P01", "type": "mouth-hem"},
        {"between": ["G01*", "G05*"], "type": "plain"}, {"between": ["G01*", "G02*"], "allowance_mm": 30}]})");
    const ProgramRun run = workshop.ripstop("check envelope.obj --project shop.json");
    EXPECT_EQ(run.code, 0) << run.out;
    EXPECT_THAT(run.out, HasSubstr("fabric         nylon 36, polyester 12\n"));
    EXPECT_THAT(run.out, HasSubstr("flat-felled 80 (25 mm)"));
    EXPECT_THAT(run.out, HasSubstr("flat-felled 4 (30 mm)"));
    EXPECT_THAT(run.out, HasSubstr("mouth-hem 12 (38 mm), hem 12 (25 mm)\n"));
    EXPECT_THAT(run.out, HasSubstr("note           shop.json: no tile is called \"H*\"\n"));
    EXPECT_THAT(run.out, HasSubstr("note           shop.json: there is no seam between \"G01*\" and \"G05*\"\n"));
    EXPECT_THAT(run.out, Not(HasSubstr("G02*")));
    EXPECT_THAT(workshop.ripstop("flatten envelope.obj --project shop.json --propose none -o plan").err,
                HasSubstr("Warning: shop.json: there is no seam between \"G01*\" and \"G05*\"\n"));
}

TEST(ProjectFile, GivesTheLayersThatAreRead) {
    const Workshop workshop;
    workshop.write_tiles("envelope.obj", {testing::flat_tile()});
    workshop.write("shop.json", R"({"layers": ["envelope::*"]})");
    const ProgramRun run = workshop.ripstop("check envelope.obj --project shop.json");
    EXPECT_EQ(run.code, 3) << "an OBJ has no layers";
    EXPECT_THAT(run.err, HasSubstr("no layer is called \"envelope::*\""));
}

}  // namespace project_test
}  // namespace ripstop
