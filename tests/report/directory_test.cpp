#include "ripstop/plan_folder/directory.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "ripstop/base/error.h"
#include "ripstop/io/mesh/flat_obj.h"
#include "ripstop/io/text/output_file.h"
#include "ripstop/pattern/piece/pieces.h"
#include "ripstop/plan_folder/cut_files.h"
#include "ripstop/report/figures/figures.h"
#include "ripstop/report/page/page_template.h"
#include "support/flat_tiles.h"
#include "support/outside.h"
#include "support/refusal.h"

namespace ripstop {
namespace directory_test {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

void write(const std::string& dir, const WriteOptions& options = {}, const CutPlan& plan = testing::two_tile_plan()) {
    write_directory(dir, plan, make_piece_set(plan, make_pieces(plan), "A"), options);
}

std::string refusal(const std::string& dir, const WriteOptions& options = {}) {
    return testing::refusal([&] { write(dir, options); });
}

std::map<std::string, std::string> files(const std::string& dir) {
    std::map<std::string, std::string> result;
    for (const auto& entry : fs::recursive_directory_iterator(dir))
        if (entry.is_regular_file())
            result[fs::relative(entry.path(), dir).string()] = testing::content(entry.path().string());
    return result;
}

std::vector<std::string> names(const std::string& dir) {
    std::vector<std::string> result;
    for (const auto& entry : fs::directory_iterator(dir)) result.push_back(entry.path().filename().string());
    std::sort(result.begin(), result.end());
    return result;
}

TEST(PlanDirectory, HoldsWhatTheContractNames) {
    const testing::ScratchDirectory scratch;
    write(scratch.path("plan"));
    std::vector<std::string> written;
    for (const auto& [name, text] : files(scratch.path("plan"))) {
        EXPECT_FALSE(text.empty()) << name;
        written.push_back(name);
    }
    if (page_template().empty()) written.insert(written.end() - 3, "report.html");  // built without Node.js
    EXPECT_THAT(written, ElementsAre("bom.csv", "cut/envelope.dxf", "cut/envelope.pdf", "cut/envelope.svg",
                                     "cut/pieces.json", "cut/tiles/Bily__dracek_.dxf", "cut/tiles/Bily__dracek_.svg",
                                     "cut/tiles/G01_P01.dxf", "cut/tiles/G01_P01.svg", "flat/Bily__dracek_.obj",
                                     "flat/G01_P01.obj", "flat/sewing.json", "pictures/Bily__dracek_.svg",
                                     "pictures/G01_P01.svg", "report.html", "report.json", "seams.csv", "tiles.csv"));
    EXPECT_THAT(names(scratch.path()), ElementsAre("plan"));
}

TEST(PlanDirectory, HasTheSameBytesEachTime) {
    const testing::ScratchDirectory scratch;
    write(scratch.path("a"), {false, true, true});
    CutPlan later = testing::two_tile_plan();
    for (FlatTile& tile : later.tiles) tile.seconds *= 2;
    write(scratch.path("b"), {false, true, true}, later);
    EXPECT_EQ(files(scratch.path("a")), files(scratch.path("b")));
}

TEST(PlanDirectory, LeavesOutWhatAFailedTileDoesNotHave) {
    const testing::ScratchDirectory scratch;
    CutPlan plan = testing::two_tile_plan();
    plan.tiles[0].flattening = {};
    write(scratch.path("plan"), {false, false, false}, plan);
    const auto written = files(scratch.path("plan"));
    EXPECT_EQ(written.count("flat/G01_P01.obj") + written.count("cut/tiles/G01_P01.dxf"), 0u);
    EXPECT_EQ(written.count("flat/Bily__dracek_.obj") + written.count("cut/tiles/Bily__dracek_.dxf"), 2u);
    EXPECT_FALSE(fs::exists(scratch.path("plan/pictures")));
    EXPECT_THAT(written.at("report.json"), HasSubstr("\"name\": \"G01 P01\""));
}

TEST(PlanDirectory, IsNotWrittenOverAnythingWithoutForce) {
    const testing::ScratchDirectory scratch;
    fs::create_directory(scratch.path("plan"));
    testing::write_text(scratch.path("plan/notes.txt"), "mine");
    EXPECT_THAT(refusal(scratch.path("plan")), HasSubstr("is not empty"));
    EXPECT_THAT(names(scratch.path("plan")), ElementsAre("notes.txt"));
    EXPECT_THAT(names(scratch.path()), ElementsAre("plan"));
    testing::write_text(scratch.path("file"), "mine");
    EXPECT_THAT(refusal(scratch.path("file"), {true, false, false}), HasSubstr("is a file"));
    EXPECT_EQ(testing::content(scratch.path("file")), "mine");
}

TEST(PlanDirectory, IsWrittenIntoAnEmptyOne) {
    const testing::ScratchDirectory scratch;
    fs::create_directory(scratch.path("plan"));
    EXPECT_EQ(refusal(scratch.path("plan") + "/"), "accepted");
    EXPECT_TRUE(fs::exists(scratch.path("plan/report.json")));
}

TEST(PlanDirectory, ReplacesAnOldPlanUnderForceAndKeepsWhatIsNotIts) {
    const testing::ScratchDirectory scratch;
    fs::create_directories(scratch.path("plan/flat"));
    fs::create_directories(scratch.path("plan/photos"));
    testing::write_text(scratch.path("plan/flat/OLD.obj"), "old");
    testing::write_text(scratch.path("plan/report.html"), "old");
    testing::write_text(scratch.path("plan/photos/first flight.txt"), "mine");
    ASSERT_EQ(refusal(scratch.path("plan"), {true, false, false}), "accepted");
    std::vector<std::string> expected{"bom.csv",     "cut",         "flat",      "photos",
                                      "report.html", "report.json", "seams.csv", "tiles.csv"};
    if (page_template().empty()) expected.erase(expected.begin() + 4);  // the old one is removed all the same
    EXPECT_EQ(names(scratch.path("plan")), expected);
    EXPECT_FALSE(fs::exists(scratch.path("plan/flat/OLD.obj")));
    EXPECT_EQ(testing::content(scratch.path("plan/photos/first flight.txt")), "mine");
    EXPECT_THAT(names(scratch.path()), ElementsAre("plan"));
}

TEST(PlanDirectory, ReplacesOnlyThoseFoldersOfExportThatHoldCutFiles) {
    const testing::ScratchDirectory scratch;
    for (const char* folder : {"cut-aama", "cut-photos"}) fs::create_directories(scratch.path("plan") + "/" + folder);
    testing::write_text(scratch.path("plan/cut-aama/envelope.dxf"), "old");
    testing::write_text(scratch.path("plan/cut-photos/table.jpg"), "mine");
    testing::write_text(scratch.path("plan/cut-list.txt"), "mine");
    ASSERT_EQ(refusal(scratch.path("plan"), {true, false, false}), "accepted");
    EXPECT_FALSE(fs::exists(scratch.path("plan/cut-aama")));
    EXPECT_EQ(testing::content(scratch.path("plan/cut-photos/table.jpg")), "mine");
    EXPECT_EQ(testing::content(scratch.path("plan/cut-list.txt")), "mine");
}

TEST(PlanDirectory, LeavesNothingHalfWrittenWhereItFails) {
    const testing::ScratchDirectory scratch;
    fs::create_directories(scratch.path("plan"));
    testing::write_text(scratch.path("plan/report.json"), "old");
    const CutPlan plan = testing::two_tile_plan();
    PieceSet pieces = make_piece_set(plan, make_pieces(plan), "A");
    // The second piece's files have no folder, which shows only when half of them are written.
    pieces.pieces[1].file = "nowhere/piece";
    EXPECT_THROW(write_directory(scratch.path("plan"), plan, pieces, {true, false, false}), InputError);
    EXPECT_THAT(names(scratch.path()), ElementsAre("plan"));
    EXPECT_EQ(testing::content(scratch.path("plan/report.json")), "old");
}

TEST(PlanDirectory, SaysWhyItCannotBeWritten) {
    const testing::ScratchDirectory scratch;
    EXPECT_THAT(refusal(scratch.path("missing/plan")), HasSubstr("is not a directory; make it first"));
    testing::write_text(scratch.path("file"), "mine");
    EXPECT_THAT(refusal(scratch.path("file/plan")), HasSubstr("cannot be written"));
    EXPECT_THAT(refusal("/proc/plan"), HasSubstr("cannot be written"));
    EXPECT_THAT(refusal(""), HasSubstr("has no name"));
    EXPECT_THAT(names(scratch.path()), ElementsAre("file"));
}

TEST(PlanDirectory, IsRefusedBelowAClosedParent) {
    if (::geteuid() == 0) GTEST_SKIP() << "nothing is closed to the superuser";
    const testing::ScratchDirectory scratch;
    fs::create_directory(scratch.path("closed"));
    fs::permissions(scratch.path("closed"), fs::perms::owner_read | fs::perms::owner_exec);
    EXPECT_THAT(refusal(scratch.path("closed/plan")), HasSubstr("Permission denied"));
    fs::permissions(scratch.path("closed"), fs::perms::owner_all);
    EXPECT_THAT(names(scratch.path("closed")), ElementsAre());
}

TEST(WriteFile, SaysThatTheDiskIsFull) {
    if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
    try {
        write_file("/dev/full", "text");
        FAIL() << "accepted";
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("/dev/full: cannot be written: No space left on device"));
    }
}

TEST(FileStems, AreSafeAndUniqueAndKeepTheirOrder) {
    EXPECT_THAT(file_stems({"G01P01", "a/b", "a_b", "A_B", "", "..", ".hidden", "ůž é", "a_b_2", "-o"}),
                ElementsAre("G01P01", "a_b", "a_b_2", "A_B_3", "_", "_..", "_.hidden", "uz_e", "a_b_2_2", "_-o"));
    EXPECT_EQ(file_stems(std::vector{std::string(500, 'x')})[0].size(), 80u);
}

TEST(FileStems, AreNoDevicesOfWindows) {
    EXPECT_THAT(
        file_stems({"CON", "nul", "Com1", "LPT9", "aux.panel", "PRN.a.b", "CONE", "COM10", "G.con", "con_"}),
        ElementsAre("CON_", "nul_", "Com1_", "LPT9_", "aux_.panel", "PRN_.a.b", "CONE", "COM10", "G.con", "con__2"));
}

TEST(FlatObj, HasEachVertexInSpaceAndOnTheCloth) {
    Points2 corners(3, 2);
    corners << 0, 0, 0.5, 0, 0, 0.25;
    const std::string text = flat_obj(testing::flat_polygon("P", corners));
    EXPECT_THAT(text, HasSubstr("v 0.5 0 0\nv 0 0.25 0\nvt 0 0\nvt 0.5 0\nvt 0 0.25\n"));
    EXPECT_EQ(text.substr(text.rfind("f ")), "f 3/3 1/1 2/2\n");
}

TEST(Clean, TakesAwayTheNoiseOfBinaryArithmetic) {
    EXPECT_EQ(clean(0.07 / 0.01), 7);
    EXPECT_EQ(clean(1.0 / 3), 0.333333333333);
    EXPECT_FALSE(std::signbit(clean(-1e-17)));
    EXPECT_EQ(clean(-1e-17), 0);
    EXPECT_EQ(clean(-123456.789), -123456.789);
}

}  // namespace directory_test
}  // namespace ripstop
