/// ripstop design special, and the other commands on its envelope.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "support/program.h"
#include "support/sanitized.h"

namespace ripstop {
namespace design_special_test {

using ::testing::ContainsRegex;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::ProgramRun;
using ::testing::StartsWith;
using testing::Workshop;

constexpr const char* bead = R"({"edge_mm": 300, "mouth_height_mm": -1200, "primitives": [
    {"name": "BODY", "type": "ellipsoid", "radii_mm": [1500, 1500, 1500], "sectors": 8, "rings": 5},
    {"name": "HORN", "type": "cone", "centre_mm": [0, 0, 1000], "axis": [1, 0, 1], "radius_mm": 700, "length_mm": 1500,
     "sectors": 6, "rings": 2}]})";

TEST(DesignSpecialCommand, WritesTilesAndSaysWhatTheyCameOutAs) {
    const Workshop workshop;
    workshop.write("shape.json", bead);
    const ProgramRun run = workshop.ripstop("design special shape.json -o bead.obj");
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_THAT(run.out, ContainsRegex("^[0-9]+ tiles \\(BODY [0-9]+, HORN [0-9]+\\)\n"));
    EXPECT_THAT(run.out, HasSubstr("Euler number 1: 1 opening, 0 handles"));
    EXPECT_THAT(run.out, HasSubstr("like a circle 1.7")) << "2 sqrt(1.5^2 - 1.2^2) = 1.8 m, less what chords cut off";
    EXPECT_THAT(workshop.names(), ElementsAre("bead.obj", "shape.json"));
    EXPECT_THAT(workshop.read("bead.obj").substr(0, 20), StartsWith("o BODY-S01R02\n"))
        << "ring 1 lies below the mouth";
}

TEST(DesignSpecialCommand, RefusesInOneSentence) {
    const Workshop workshop;
    workshop.write("shape.json", R"({"edge_mm": 300, "primitives": [{"name": "A", "type": "cube"}]})");
    const ProgramRun run = workshop.ripstop("design special shape.json -o a.obj");
    EXPECT_EQ(run.code, 3);
    EXPECT_THAT(run.out, IsEmpty());
    EXPECT_THAT(run.err,
                StartsWith("ripstop: shape.json: primitive 1 (A): the type \"cube\" is unknown, expected one of"));
    EXPECT_THAT(workshop.names(), ElementsAre("shape.json"));
    EXPECT_EQ(workshop.ripstop("design special none.json -o a.obj").code, 3);
    EXPECT_EQ(workshop.ripstop("design special -o a.obj").code, 2);
    workshop.write("bead.json", bead);
    workshop.write("a.obj", "");
    EXPECT_THAT(workshop.ripstop("design special bead.json -o a.obj").err, HasSubstr("a.obj: exists"));
}

TEST(DesignSpecialCommand, TheExampleIsSoundAndNearlyAllOfItCanBeMade) {
    RIPSTOP_TOO_LONG_SANITIZED();
    const Workshop workshop;
    ASSERT_EQ(workshop.ripstop("design special " RIPSTOP_SOURCE_DIR "/docs/special.example.json -o bear.obj").code, 0);
    const ProgramRun check = workshop.ripstop("check bear.obj --unit m");
    EXPECT_EQ(check.code, 0) << check.out;
    EXPECT_THAT(check.out, HasSubstr("Sound: nothing is wrong"));
    ASSERT_LE(workshop.ripstop("flatten bear.obj --unit m --quiet -o plan").code, 1);
    const auto report = nlohmann::json::parse(workshop.read("plan/report.json"));
    EXPECT_LT(report["envelope"]["failed"].size(), report["tiles"].size() / 20);
}

}  // namespace design_special_test
}  // namespace ripstop
