/// `check` and `flatten` on seams whose length the mesh leaves uncertain.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "support/program.h"
#include "support/shared_data.h"
#include "support/zigzags.h"

namespace ripstop {
namespace doubtful_seams_test {

using ::testing::HasSubstr;
using testing::ProgramRun;
using testing::Workshop;
using Json = nlohmann::json;

TEST(ZigzagDisc, IsRefusedAndWithFairSeamsJudgedAsTheSmoothCutIs) {
    const Workshop workshop;
    workshop.write_tiles("disc.obj", {{"DISC", testing::zigzag_disc(0.2, 8, 0.15, 2), {}}});
    const ProgramRun check = workshop.ripstop("check disc.obj --unit m --json");
    const Json checked = Json::parse(check.out);
    ASSERT_EQ(checked["zigzags"].size(), 1u);
    EXPECT_GT(checked["zigzags"][0]["teeth_mm"].get<double>(), 100);
    EXPECT_THAT(checked["notes"].dump(), HasSubstr("--fair-seams"));

    const ProgramRun run = workshop.ripstop("flatten disc.obj --unit m --propose none -o plan");
    EXPECT_EQ(run.code, 1) << run.out << run.err;
    const Json tile = Json::parse(workshop.read("plan/report.json"))["tiles"][0];
    // A notch between two teeth, sharper than 55 degrees, has no room for the hems of its flanks; that is reported
    // too.
    int zigzags = 0;
    for (const Json& finding : tile["verdict"]["findings"]) {
        if (finding["code"] == "zigzag") {
            ++zigzags;
            EXPECT_THAT(finding["message"].get<std::string>(), HasSubstr(" mm high"));
        } else {
            EXPECT_EQ(finding["code"], "allowances_meet") << finding.dump();
            EXPECT_LT(finding["value"].get<double>(), 50) << "two hems of 25 mm";
        }
    }
    EXPECT_EQ(zigzags, 1) << tile["verdict"].dump();

    const ProgramRun fitted = workshop.ripstop("flatten disc.obj --unit m --propose none --allowance-fit -o fitted");
    EXPECT_EQ(fitted.code, 1) << fitted.out << fitted.err;
    const Json alone = Json::parse(workshop.read("fitted/report.json"))["tiles"][0];
    ASSERT_EQ(alone["verdict"]["findings"].size(), 1u) << alone["verdict"].dump();
    EXPECT_EQ(alone["verdict"]["findings"][0]["code"], "zigzag");

    const ProgramRun fair = workshop.ripstop("flatten disc.obj --unit m --propose none --fair-seams -o fair");
    EXPECT_EQ(fair.code, 1) << fair.out << fair.err;
    EXPECT_THAT(fair.err, HasSubstr("cut along a fair curve"));
    const Json faired = Json::parse(workshop.read("fair/report.json"))["tiles"][0];
    EXPECT_EQ(faired["verdict"]["findings"][0]["code"], "isoperimetric");
    for (const Json& finding : faired["verdict"]["findings"]) EXPECT_NE(finding["code"], "allowances_meet");
    EXPECT_NEAR(faired["area_error_pct"].get<double>(), -100 * 0.2 / (4 * std::numbers::pi), 0.3);
}

TEST(ZigzagDisc, OfTheSharedDataIsRefused) {
    RIPSTOP_REQUIRE_SHARED(file, "faults/shapes/zigzag_disc.obj");
    const Workshop workshop;
    const std::string command = "flatten " + file.string() + " --unit m --fabric nylon --propose none ";
    const ProgramRun run = workshop.ripstop(command + "-o plan");
    EXPECT_EQ(run.code, 1) << run.out << run.err;
    EXPECT_THAT(workshop.read("plan/report.json"), HasSubstr("\"zigzag\""));
    EXPECT_EQ(workshop.ripstop(command + "--fair-seams -o fair").code, 1);
    const Json faired = Json::parse(workshop.read("fair/report.json"))["tiles"][0];
    EXPECT_NEAR(faired["area_error_pct"].get<double>(), -1.57, 0.3);
}

TEST(RoundPool, OfTheSharedDataIsCutAsWideAboveAsBelow) {
    RIPSTOP_REQUIRE_SHARED(file, "faults/shapes/round_pool.obj");
    const Workshop workshop;
    for (const std::string mode : {"auto", "never"}) {
        const std::string options = " " + file.string() + " --unit m --remesh " + mode;
        const ProgramRun run = workshop.ripstop("flatten" + options + " -o " + mode);
        EXPECT_EQ(run.code, workshop.ripstop("check" + options).code) << run.out << run.err;
        const Json report = Json::parse(workshop.read(mode + "/report.json"));
        double below = 0, above = 0;
        for (const Json& tile : report["tiles"])
            for (const Json& chain : tile["chains"])
                (tile["name"] == "WALL" ? above : below) =
                    std::max(tile["name"] == "WALL" ? above : below, chain["flat_length_mm"].get<double>());
        EXPECT_NEAR(below, above, 0.2) << mode;
        if (run.code == 0) {
            EXPECT_NEAR(above, 4000 * std::numbers::pi, 2) << mode;
        }
        if (run.code == 1) {
            EXPECT_THAT(run.out, HasSubstr("export a mesh whose edges turn by less than")) << mode;
        }
    }
    EXPECT_EQ(workshop.ripstop("check " + file.string() + " --unit m --remesh never").code, 1);
}

}  // namespace doubtful_seams_test
}  // namespace ripstop
