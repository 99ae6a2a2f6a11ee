#include "ripstop/pipeline/plan.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <functional>

#include "ripstop/base/error.h"
#include "ripstop/design/natural/gores.h"
#include "ripstop/io/mesh/mesh_file.h"
#include "ripstop/pipeline/flight/inflate_plan.h"
#include "ripstop/plan_folder/update_folder.h"
#include "ripstop/report/json/report_json.h"
#include "support/balloons.h"
#include "support/envelopes.h"
#include "support/outside.h"
#include "support/refusal.h"
#include "support/sanitized.h"
#include "support/shapes.h"

namespace ripstop {
namespace plan_test {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const EnvelopeDesign small{.gores = 16, .panels = 6, .volume = 300, .edge_length = 0.4};

/// Writes the drawn tiles of an envelope to a file.
void write_drawn(const std::string& file, const Envelope& envelope) {
    std::vector<NamedMesh> tiles;
    for (const Tile& tile : envelope.tiles) tiles.push_back({tile.name, tile.mesh});
    std::ofstream out(file);
    write_model(out, file, tiles);
}

Job in_metres() {
    Job job;
    job.read.unit = LengthUnit{};
    job.fabric_name = "nylon";
    return job;
}

/// A hemisphere as one tile, which no method can make.
Envelope impossible() {
    return testing::tiles_of({{"dome", testing::cap(1.3, 12)}});
}

using testing::refusal;

TEST(Plan, OfALibraryUserIsThatOfTheCommand) {
    const testing::ScratchDirectory scratch;
    write_drawn(scratch.path("drawn.obj"), testing::balloon(small));
    std::vector<PlanStage> stages;
    PlanWatch watch;
    watch.stage = [&](PlanStage stage) { stages.push_back(stage); };
    const Plan plan = plan_envelope(scratch.path("drawn.obj"), in_metres(), watch);
    EXPECT_EQ(plan.cut.input_file, "drawn.obj");
    EXPECT_EQ(plan.cut.input_sha256, sha256_of_file(scratch.path("drawn.obj")));
    EXPECT_EQ(plan.pieces.revision, plan.cut.input_sha256.substr(0, 8));
    EXPECT_EQ(plan.pieces.pieces.size(), plan.cut.tiles.size());
    EXPECT_TRUE(plan.is_good());
    EXPECT_EQ(stages, (std::vector{PlanStage::read, PlanStage::flatten, PlanStage::propose, PlanStage::pieces}));
}

TEST(Plan, FromMemoryIsThatFromAFile) {
    const testing::ScratchDirectory scratch;
    const Envelope drawn = testing::balloon(small);
    write_drawn(scratch.path("drawn.obj"), drawn);
    const Plan file = plan_envelope(scratch.path("drawn.obj"), in_metres());
    const Plan memory = plan_envelope(drawn, in_metres());
    EXPECT_EQ(memory.cut.input_file, "");
    ASSERT_EQ(memory.cut.tiles.size(), file.cut.tiles.size());
    EXPECT_EQ(memory.cut.seams.size(), file.cut.seams.size());
    for (std::size_t i = 0; i < file.cut.tiles.size(); ++i)
        EXPECT_NEAR(memory.cut.tiles[i].accuracy.flat_area, file.cut.tiles[i].accuracy.flat_area, 1e-6);
    EXPECT_TRUE(memory.is_good());
}

TEST(Plan, SaysWhatIsWrongWithTheEnvelopeAndWhatToDrawInstead) {
    const Plan plan = plan_envelope(impossible(), in_metres());
    EXPECT_FALSE(plan.is_good());
    EXPECT_TRUE(plan.cut.tiles[0].proposal.has_value());
    Job none = in_metres();
    none.propose = ProposeScope::none;
    EXPECT_FALSE(plan_envelope(impossible(), none).cut.tiles[0].proposal.has_value());
}

TEST(Plan, ThatIsReadAgainReportsTheSameBytes) {
    const testing::ScratchDirectory scratch;
    int folder = 0;
    for (const Envelope& drawn : {testing::balloon(small), impossible()}) {
        Plan plan = plan_envelope(drawn, in_metres());
        plan.cut.input_file = "drawn.obj";
        plan.cut.remarks = {"a remark"};
        plan.cut.warnings = {"a warning"};
        const std::string path = scratch.path("plan" + std::to_string(folder++));
        EXPECT_THAT(write_plan(path, plan), IsEmpty());
        const Plan again = read_plan(path);
        EXPECT_EQ(report_json(again.cut), testing::content(path + "/report.json"));
        EXPECT_EQ(again.pieces.pieces.size(), plan.pieces.pieces.size());
        write_plan(path + "-again", again);
        for (const char* file : {"report.json", "report.html", "tiles.csv", "seams.csv", "bom.csv", "flat/sewing.json",
                                 "cut/pieces.json", "cut/envelope.dxf"})
            EXPECT_TRUE(testing::content(path + "-again/" + file) == testing::content(path + "/" + file)) << file;
    }
}

TEST(Plan, ThatWasWrittenWithoutSecondsHasNoneWhenItIsReadAgain) {
    const testing::ScratchDirectory scratch;
    write_plan(scratch.path("plan"), plan_envelope(testing::balloon(small), in_metres()), {.reproducible = true});
    const Plan again = read_plan(scratch.path("plan"));
    EXPECT_EQ(report_json(again.cut, false), report_json(again.cut, true));
}

TEST(Plan, IsUpdatedInFlightAndKeepsAllElse) {
    RIPSTOP_TOO_LONG_SANITIZED();
    const testing::ScratchDirectory scratch;
    const std::string path = scratch.path("plan");
    write_plan(path, plan_envelope(testing::balloon(small), in_metres()));
    const std::string pieces = testing::content(path + "/cut/pieces.json");
    Plan plan = read_plan(path);
    plan.cut.inflated = inflate_plan(plan.cut, {});
    update_plan(path, plan, {.reproducible = true});
    EXPECT_EQ(testing::content(path + "/report.json"), report_json(plan.cut, true));
    EXPECT_TRUE(std::filesystem::exists(path + "/inflated/envelope.obj"));
    EXPECT_EQ(testing::content(path + "/cut/pieces.json"), pieces);
}

TEST(Plan, IsNotUpdatedWhereAnotherRunWroteMeanwhile) {
    RIPSTOP_TOO_LONG_SANITIZED();
    const testing::ScratchDirectory scratch;
    const std::string path = scratch.path("plan");
    write_plan(path, plan_envelope(testing::balloon(small), in_metres()));
    Plan first = read_plan(path), second = read_plan(path);
    first.cut.inflated = inflate_plan(first.cut, {});
    second.cut.inflated = first.cut.inflated;
    update_plan(path, first);
    const std::string kept = testing::content(path + "/report.json");
    EXPECT_THAT(refusal([&] { update_plan(path, second); }), HasSubstr("another run has changed it in the meantime"));
    EXPECT_EQ(testing::content(path + "/report.json"), kept);
    for (const auto& entry : std::filesystem::directory_iterator(path))
        EXPECT_THAT(entry.path().filename().string(), ::testing::Not(HasSubstr(".ripstop-")));
}

TEST(Plan, ShowsTheRollThroughLaterUpdates) {
    RIPSTOP_TOO_LONG_SANITIZED();
    const testing::ScratchDirectory scratch;
    const std::string path = scratch.path("plan");
    write_plan(path, plan_envelope(testing::balloon(small), in_metres()));
    const std::string bare = testing::content(path + "/report.html");
    if (bare.empty()) GTEST_SKIP() << "built without the page";
    const Unchanged read({path + "/cut/pieces.json"});
    EXPECT_TRUE(show_roll(path, "{\"markers\": []}", read));
    EXPECT_NE(testing::content(path + "/report.html"), bare);
    Plan plan = read_plan(path);
    plan.cut.inflated = inflate_plan(plan.cut, {});
    update_plan(path, plan);
    const auto roll = [](const std::string& page) { return page.substr(page.find("id=\"ripstop-roll\">"), 40); };
    EXPECT_NE(roll(testing::content(path + "/report.html")), roll(bare));
    testing::write_text(path + "/cut/pieces.json", "{}");
    EXPECT_THAT(refusal([&] { show_roll(path, "{}", read); }), HasSubstr("another run"));
    testing::write_text(path + "/report.html", "another page");
    EXPECT_FALSE(show_roll(path, "{}", Unchanged({path + "/cut/pieces.json"})));
}

TEST(Plan, LeavesAPdfOutThatNobodyPrintsAndSaysSo) {
    const testing::ScratchDirectory scratch;
    Plan plan = plan_envelope(testing::balloon(small), in_metres());
    plan.cut.findings.push_back({"unit", "no balloon is so large", Vec3::Zero(), 1, 0});
    EXPECT_THAT(write_plan(scratch.path("plan"), plan), Contains(HasSubstr("no PDF is written")));
    EXPECT_FALSE(std::filesystem::exists(scratch.path("plan/cut/envelope.pdf")));
    EXPECT_THAT(testing::content(scratch.path("plan/report.json")), HasSubstr("no PDF is written"));
}

TEST(Plan, TakesFromTheProjectWhatTheJobDoesNotSay) {
    Project project;
    project.unit = "mm";
    project.seam_tolerance = 0.001;
    project.accept = {"missing_tile"};
    Job job;
    job.read.project = project;
    const Job whole = completed(job);
    ASSERT_TRUE(whole.read.unit.has_value());
    EXPECT_EQ(whole.read.unit->name, "mm");
    EXPECT_EQ(whole.read.seam_tolerance, 0.001);
    EXPECT_THAT(whole.accept, Contains("missing_tile"));
    job.seam_tolerance = 0.002;
    job.read.unit = LengthUnit{"m", 1};
    EXPECT_EQ(completed(job).read.seam_tolerance, 0.002);
    EXPECT_EQ(completed(job).read.unit->name, "m");
    job.fabric_name = "no-such-fabric";
    EXPECT_THAT(refusal([&] { completed(job); }), HasSubstr("no-such-fabric"));
}

}  // namespace plan_test
}  // namespace ripstop
