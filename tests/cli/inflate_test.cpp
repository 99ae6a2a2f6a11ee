#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "support/program.h"
#include "support/sanitized.h"

namespace ripstop {
namespace inflate_test {

using Json = nlohmann::json;
using ::testing::HasSubstr;
using testing::ProgramRun;
using testing::Workshop;

/// Makes the plan of a small, coarse balloon; its meshes are the drawing.
void make_plan(const Workshop& workshop, const std::string& options = "") {
    EXPECT_EQ(workshop.ripstop("design natural --gores 24 --panels 6 --volume 600 --edge 400mm -o e.obj").code, 0);
    const ProgramRun run =
        workshop.ripstop("flatten e.obj --unit m --fabric nylon --remesh never --reproducible -o plan " + options);
    EXPECT_LE(run.code, 1) << run.err;
}

TEST(InflateCommand, PutsTheFlightIntoReportPageAndShape) {
    const Workshop workshop;
    make_plan(workshop);
    const Json before = Json::parse(workshop.read("plan/report.json"));
    const std::string page = workshop.read("plan/report.html");
    const ProgramRun run = workshop.ripstop("inflate plan --tapes meridians --reproducible");
    EXPECT_LE(run.code, 1) << run.err;
    EXPECT_THAT(run.out, HasSubstr("off the drawn shape"));
    Json after = Json::parse(workshop.read("plan/report.json"));
    const Json flight = after["inflated"];
    EXPECT_TRUE(flight["converged"]);
    for (const char* key :
         {"deviation_rms_mm", "deviation_max_mm", "height_mm", "drawn_height_mm", "volume_m3", "drawn_volume_m3",
          "lift_n", "stress_max_n_per_m", "tape_force_max_n", "wrinkled_pct", "safety_factor", "iterations"})
        EXPECT_TRUE(flight[key].is_number()) << key;
    EXPECT_GT(flight["lift_n"], 0);
    EXPECT_NEAR(flight["volume_m3"].get<double>(), 600, 30);
    after.erase("inflated");
    for (Json& tile : after["tiles"]) tile.erase("inflated");
    EXPECT_EQ(after["tiles"], before["tiles"]) << "what was found of the patterns stays";
    EXPECT_NE(workshop.read("plan/report.html"), page);
    EXPECT_THAT(workshop.read("plan/inflated/envelope.obj"), HasSubstr("o G01P01"));
    const std::string report = workshop.read("plan/report.json"), shape = workshop.read("plan/inflated/envelope.obj");
    EXPECT_LE(workshop.ripstop("inflate plan --tapes meridians --reproducible --quiet --jobs 1").code, 1);
    EXPECT_EQ(workshop.read("plan/report.json"), report) << "the same again, on one thread";
    EXPECT_EQ(workshop.read("plan/inflated/envelope.obj"), shape);
}

TEST(InflateCommand, FindsTheSameInOneSectorAndInTheWhole) {
    RIPSTOP_TOO_LONG_SANITIZED();
    const Workshop workshop;
    make_plan(workshop);
    const Json sector = Json::parse(workshop.ripstop("inflate plan --tapes meridians --json --quiet").out)["inflated"];
    const Json whole =
        Json::parse(workshop.ripstop("inflate plan --tapes meridians --json --quiet --whole").out)["inflated"];
    EXPECT_EQ(sector["sectors"], 24);
    EXPECT_EQ(whole["sectors"], 1);
    // Both are in equilibrium to 1e-4 of pressure times edge squared, some hundredths of a millimetre.
    EXPECT_NEAR(sector["deviation_rms_mm"].get<double>(), whole["deviation_rms_mm"].get<double>(), 0.1);
    EXPECT_NEAR(sector["lift_n"].get<double>(), whole["lift_n"].get<double>(), 0.1);
}

TEST(FlattenCommand, CompensatesUntilTheEnvelopeIsAsDrawn) {
    RIPSTOP_TOO_LONG_SANITIZED();
    const Workshop workshop;
    make_plan(workshop, "--compensate --tapes meridians");
    const Json report = Json::parse(workshop.read("plan/report.json"));
    const Json flight = report["inflated"];
    EXPECT_LT(flight["deviation_rms_mm"].get<double>(), 0.001 * flight["drawn_height_mm"].get<double>());
    EXPECT_NEAR(flight["volume_m3"].get<double>() / flight["drawn_volume_m3"].get<double>(), 1, 0.003);
    EXPECT_GT(flight["rounds"].size(), 2u);
    EXPECT_GT(flight["rounds"][0]["moved_rms_mm"].get<double>(), 2 * flight["moved_rms_mm"].get<double>());
    for (const Json& seam : report["seams"]) EXPECT_LT(std::abs(seam["mismatch_pct"].get<double>()), 0.1);
    EXPECT_EQ(report["envelope"]["failed_seams"].size(), 0u);
    // The cut pieces are inflated: sewn again from the files.
    const Json again = Json::parse(workshop.ripstop("inflate plan --json --quiet").out)["inflated"];
    EXPECT_NEAR(again["deviation_rms_mm"].get<double>(), flight["deviation_rms_mm"].get<double>(), 0.1);
}

TEST(InflateCommand, SaysWhatIsNoPlanToSew) {
    const Workshop workshop;
    workshop.write("empty/x.txt", "");
    const ProgramRun run = workshop.ripstop("inflate empty");
    EXPECT_EQ(run.code, 3);
    EXPECT_THAT(run.err, HasSubstr("flat/sewing.json"));
    workshop.write("plan/flat/sewing.json", "{");
    EXPECT_EQ(workshop.ripstop("inflate plan").code, 3);
    EXPECT_EQ(workshop.ripstop("inflate plan --inside cold").code, 2);
}

TEST(FlattenCommand, RefusesToCompensateAPart) {
    const Workshop workshop;
    workshop.write_tiles("e.obj", {testing::bent_tile()});
    const ProgramRun run = workshop.ripstop("flatten e.obj --unit m --compensate --tile cylinder -o plan");
    EXPECT_EQ(run.code, 2);
    EXPECT_THAT(run.err, HasSubstr("--tile"));
}

}  // namespace inflate_test
}  // namespace ripstop
