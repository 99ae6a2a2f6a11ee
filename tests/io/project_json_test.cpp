#include "ripstop/io/json/project_json.h"

#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "ripstop/base/error.h"
#include "ripstop/pipeline/read/tile_options.h"
#include "ripstop/tile/make_tile.h"
#include "support/refusal.h"

namespace ripstop {
namespace project_json_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

Project read(const std::string& text) {
    std::istringstream in(text);
    return read_project(in, "plan.json");
}

std::string refusal(const std::string& text) {
    return testing::refusal([&] { read(text); });
}

TEST(ProjectJson, JudgesTheCasesAsTheSchemaDoes) {
    std::ifstream in(RIPSTOP_SOURCE_DIR "/tests/data/project_cases.json");
    const nlohmann::json cases = nlohmann::json::parse(in);
    EXPECT_GT(cases.size(), 20U);
    for (const auto& entry : cases) {
        SCOPED_TRACE(entry["what"].get<std::string>());
        if (entry["sound"]) {
            EXPECT_EQ(refusal(entry["project"].dump()), "accepted");
        } else {
            EXPECT_THAT(refusal(entry["project"].dump()), StartsWith("plan.json: "));
            EXPECT_THAT(refusal(entry["project"].dump()), HasSubstr(entry.at("says").get<std::string>()));
        }
    }
}

TEST(ProjectJson, RefusesWhatASchemaCannotSay) {
    EXPECT_THAT(refusal(R"({"tiles": [{"name": "a", "warp": {"direction": [0, 0, 0]}}]})"),
                HasSubstr("tile 1 (\"a\"): warp: the warp has no direction, expected a vector"));
    EXPECT_THAT(refusal(R"({"tiles": [{"name": "a", "warp": {"from": [1, 2, 3], "to": [1, 2, 3]}}]})"),
                HasSubstr("expected two different points"));
    EXPECT_THAT(refusal(R"({"tiles": [{"name": "a"}, {"name": "b"}, {"name": "a"}]})"),
                HasSubstr("tiles 1 and 3 have the same name \"a\""));
    EXPECT_THAT(refusal(R"({"seams": [{"free": "a", "type": "glue"}]})"),
                HasSubstr("seams: 1: no seam type \"glue\"; known: flat-felled, french"));
    EXPECT_THAT(refusal(R"({"seam_types": [{"name": "a", "allowance_mm": 1}, {"name": "a", "allowance_mm": 2}]})"),
                HasSubstr("seam_types: 2: the type \"a\" occurs twice"));
    EXPECT_THAT(refusal(R"({"unit": "m", "unit": "mm"})"), HasSubstr("the key \"unit\" occurs twice"));
    EXPECT_THAT(refusal("{\"unit\": \"m\"\n\"fabric\": 1}"), StartsWith("plan.json:2: not JSON from"));
}

TEST(ProjectJson, ReadsTheExampleInTheDocs) {
    std::ifstream in(RIPSTOP_SOURCE_DIR "/docs/project.example.json");
    const Project project = read_project(in, "example");
    EXPECT_EQ(project.unit, "mm");
    EXPECT_EQ(project.fabric, "nylon");
    EXPECT_EQ(project.tiles.size(), 5U);
    EXPECT_EQ(project.tiles[3].source, "envelope_03");
    EXPECT_EQ(project.tiles[4].at, Vec3(1830, 750, 520));
    EXPECT_EQ(project.materials.at("top cloth"), "nylon-silicone");
    EXPECT_THAT(project.layers, ElementsAre("envelope", "envelope::*"));
    EXPECT_THAT(project.grain_layers, ElementsAre("yarn"));
    ASSERT_EQ(project.seams.size(), 5U);
    EXPECT_EQ(project.seams[1].type, (SeamType{"welded", 0.015, 0, false}));
    EXPECT_EQ(project.seams[4].type, (SeamType{"hem", 0.04, 2, false}));
    const Tolerances limits = tolerances(project, {});
    EXPECT_DOUBLE_EQ(limits.area, 0.01);
    EXPECT_DOUBLE_EQ(limits.length, 0.001);
    EXPECT_FALSE(limits.strain_for_all) << "each fabric has its own";
}

TEST(ProjectTolerances, OfStrainAndShearHoldForEveryFabric) {
    const Tolerances limits = tolerances(read(R"({"tolerances": {"strain_pct": 2, "shear_deg": 10}})"), {});
    EXPECT_DOUBLE_EQ(limits.strain, 0.02);
    EXPECT_DOUBLE_EQ(limits.shear, 10 * degree);
    EXPECT_TRUE(limits.strain_for_all);
    EXPECT_TRUE(limits.shear_for_all);
}

TEST(ProjectTolerances, KeepTheDefaultsWhereTheProjectIsSilent) {
    const Tolerances limits = tolerances(read(R"({"tolerances": {"length_pct": 0.5}})"), {.area = 0.03, .shear = 0.1});
    EXPECT_EQ(limits.area, 0.03);
    EXPECT_DOUBLE_EQ(limits.length, 0.005);
    EXPECT_EQ(limits.shear, 0.1);
}

TEST(ProjectTiles, GiveWarpAndCornersInMetres) {
    const Project project = read(R"({"tiles": [{"name": "a", "warp": {"from": [100, 0, 0], "to": [100, 30, 40]},
                                                "corners": [[1000, 0, 0], [0, 250, 0]]}]})");
    const TileOptions options = tile_options(project, "a", 0.001);
    EXPECT_TRUE(options.warp->isApprox(Vec3(0, 0.6, 0.8)));
    EXPECT_EQ(options.warp_source, "plan.json, tile \"a\"");
    ASSERT_EQ(options.corners.size(), 2U);
    EXPECT_TRUE(options.corners[1].isApprox(Vec3(0, 0.25, 0)));
}

TEST(ProjectTiles, ExactNamesGoBeforePatternsAndLaterPatternsBeforeEarlier) {
    const Project project = read(R"({"tiles": [{"name": "G01P01", "warp": {"direction": [1, 0, 0]}},
                                               {"name": "*", "warp": {"direction": [0, 1, 0]}},
                                               {"name": "G01*", "warp": {"direction": [0, 0, 1]}}]})");
    EXPECT_EQ(*tile_options(project, "G01P01", 1).warp, Vec3::UnitX());
    EXPECT_EQ(*tile_options(project, "G01P02", 1).warp, Vec3::UnitZ());
    EXPECT_EQ(*tile_options(project, "G02P01", 1).warp, Vec3::UnitY());
}

TEST(ProjectTiles, TurnTheLongestAxis) {
    const Project project = read(R"({"tiles": [{"name": "*", "warp": {"direction": [0, 0, 1]}},
                                               {"name": "b", "warp": {"turn_deg": 0}},
                                               {"name": "c", "warp": {"turn_deg": -90}}]})");
    EXPECT_FALSE(tile_options(project, "a", 1).grain_turn);
    EXPECT_EQ(tile_options(project, "b", 1).grain_turn, 0);
    EXPECT_FALSE(tile_options(project, "b", 1).warp) << "one entry decides of the warp";
    EXPECT_DOUBLE_EQ(*tile_options(project, "c", 1).grain_turn, -90 * degree);
}

TEST(ProjectTiles, TakeWarpAndCornersFromDifferentEntries) {
    const Project project = read(R"({"tiles": [{"name": "G*", "warp": {"direction": [0, 0, 1]}},
                                               {"name": "G01", "corners": [[1, 2, 3]]}]})");
    EXPECT_TRUE(tile_options(project, "G01", 1).warp);
    EXPECT_EQ(tile_options(project, "G01", 1).corners.size(), 1U);
    EXPECT_TRUE(tile_options(project, "G02", 1).corners.empty());
    EXPECT_FALSE(tile_options(project, "H01", 1).warp);
}

TEST(ProjectTiles, ThatFitNothingAreNamed) {
    const Project project = read(R"({"tiles": [{"name": "G*"}, {"name": "H01"}, {"name": "?03"}]})");
    EXPECT_THAT(unused_names(project, {"G01", "G02"}), ElementsAre("H01", "?03"));
}

}  // namespace project_json_test
}  // namespace ripstop
