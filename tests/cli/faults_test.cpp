/// `flatten` on a faulty envelope.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "support/envelopes.h"
#include "support/program.h"
#include "support/shapes.h"

namespace ripstop {
namespace faults_test {

using ::testing::HasSubstr;
using testing::ProgramRun;
using testing::Workshop;

/// Three sheets of 1 m x 1 m side by side, with gaps of `gap`.
std::vector<NamedMesh> sheets(double gap) {
    std::vector<NamedMesh> tiles;
    for (int i = 0; i < 3; ++i) {
        TriangleMesh mesh = testing::rectangle(1, 1, 4, 4);
        mesh.positions.col(0).array() += i * (1 + gap);
        tiles.push_back({std::string(1, static_cast<char>('a' + i)), mesh, {}});
    }
    return tiles;
}

TEST(FlattenFaults, ASoundSheetIsMade) {
    const Workshop workshop;
    workshop.write_tiles("sheets.obj", sheets(0));
    const ProgramRun run = workshop.ripstop("flatten sheets.obj --unit m -o plan");
    EXPECT_EQ(run.code, 0) << run.out << run.err;
}

TEST(FlattenFaults, ATileTwiceIsAFindingThoughAllFilesAreWritten) {
    const Workshop workshop;
    std::vector<NamedMesh> tiles = sheets(0);
    tiles.push_back({"again", tiles[1].mesh, {}});
    workshop.write_tiles("sheets.obj", tiles);
    const ProgramRun run = workshop.ripstop("flatten sheets.obj --unit m -o plan");
    EXPECT_EQ(run.code, 1);
    EXPECT_THAT(run.out, HasSubstr("again"));
    const auto report = nlohmann::json::parse(workshop.read("plan/report.json"));
    EXPECT_FALSE(report["envelope"]["manufacturable"].get<bool>());
    ASSERT_FALSE(report["envelope"]["findings"].empty());
    EXPECT_EQ(report["envelope"]["findings"][0]["code"], "doubled");
    EXPECT_THAT(workshop.read("plan/tiles.csv"), HasSubstr("again"));
}

TEST(FlattenFaults, AGapIsAFindingUnlessTheSeamToleranceAllowsIt) {
    const Workshop workshop;
    workshop.write_tiles("sheets.obj", sheets(0.001));
    EXPECT_EQ(workshop.ripstop("flatten sheets.obj --unit m -o plan").code, 1);
    const auto report = nlohmann::json::parse(workshop.read("plan/report.json"));
    ASSERT_EQ(report["envelope"]["findings"].size(), 2U) << "one for each gap";
    for (const auto& finding : report["envelope"]["findings"]) {
        EXPECT_EQ(finding["code"], "gap");
        EXPECT_NEAR(finding["value"].get<double>(), 1, 1e-6);
        EXPECT_EQ(finding["limit"], 0.5);
    }
    EXPECT_EQ(workshop.ripstop("flatten sheets.obj --unit m --seam-tolerance 2mm -o other").code, 0);
}

TEST(FlattenFaults, AreNotAskedForWhereSomeTilesAreChosen) {
    const Workshop workshop;
    workshop.write_tiles("sheets.obj", sheets(0.001));
    EXPECT_EQ(workshop.ripstop("flatten sheets.obj --unit m --tile a --tile b -o plan").code, 0);
}

std::vector<NamedMesh> tube_with_a_window() {
    std::vector<NamedMesh> tiles = testing::square_tube();
    std::erase_if(tiles, [](const NamedMesh& tile) { return tile.name == "T1-1"; });
    return tiles;
}

struct Runs {
    ProgramRun check, flatten;
};

Runs expect_both_end_with(const Workshop& workshop, const std::string& arguments, int code) {
    Runs runs{workshop.ripstop("check " + arguments), workshop.ripstop("flatten " + arguments + " --force -o plan")};
    EXPECT_EQ(runs.check.code, code) << arguments << "\n" << runs.check.out << runs.check.err;
    EXPECT_EQ(runs.flatten.code, code) << arguments << "\n" << runs.flatten.out << runs.flatten.err;
    return runs;
}

TEST(WhatMayBeMeant, IsWrongForCheckAndFlattenUntilItIsAccepted) {
    const Workshop workshop;
    workshop.write_tiles("tent.obj", tube_with_a_window());
    const Runs refused = expect_both_end_with(workshop, "tent.obj --unit m", 1);
    const std::string sentence = "a tile is missing at (2.00, 1.00, 1.50) m: the loose edges of ";
    EXPECT_THAT(refused.check.out, HasSubstr("WRONG          " + sentence));
    EXPECT_THAT(refused.flatten.out, HasSubstr("  " + sentence));
    EXPECT_THAT(refused.flatten.out, HasSubstr("; if the opening is intended, give --accept missing_tile\n"));
    auto report = nlohmann::json::parse(workshop.read("plan/report.json"));
    ASSERT_EQ(report["envelope"]["findings"].size(), 1U);
    EXPECT_EQ(report["envelope"]["findings"][0]["code"], "missing_tile");
    EXPECT_TRUE(report["envelope"]["warnings"].empty());
    EXPECT_THAT(report["envelope"]["says"]["why"].dump(), HasSubstr(sentence));

    const Runs accepted = expect_both_end_with(workshop, "tent.obj --unit m --accept missing_tile", 0);
    EXPECT_THAT(accepted.check.out, HasSubstr("note           " + sentence));
    EXPECT_THAT(accepted.flatten.err, HasSubstr("Note: " + sentence));
    report = nlohmann::json::parse(workshop.read("plan/report.json"));
    EXPECT_TRUE(report["envelope"]["manufacturable"].get<bool>());
    EXPECT_THAT(report["input"]["remarks"].dump(), HasSubstr("; that is accepted (missing_tile)"));

    workshop.write("shop.json", R"({"unit": "m", "accept": ["missing_tile"]})");
    expect_both_end_with(workshop, "tent.obj --project shop.json", 0);
    expect_both_end_with(workshop, "tent.obj --unit m --accept missing_tile,missing_tile", 0);
    expect_both_end_with(workshop, "tent.obj --unit m --tile 'T0*'", 0);
}

TEST(WhatMayBeMeant, IsNamedWhereAnotherCodeIsGiven) {
    const Workshop workshop;
    workshop.write_tiles("tent.obj", tube_with_a_window());
    const Runs runs = expect_both_end_with(workshop, "tent.obj --unit m --accept gap", 2);
    EXPECT_THAT(runs.check.err, HasSubstr("--accept: no \"gap\"; known: missing_tile"));
    workshop.write("shop.json", R"({"accept": ["shifted"]})");
    const Runs project = expect_both_end_with(workshop, "tent.obj --project shop.json", 3);
    EXPECT_THAT(project.check.err, HasSubstr("accept: \"shifted\" cannot be accepted, expected one of: missing_tile"));
}

TEST(TilesWithoutASeam, AreANoteOfBoth) {
    const Workshop workshop;
    workshop.write_tiles("sheets.obj", sheets(1));
    const Runs runs = expect_both_end_with(workshop, "sheets.obj --unit m", 0);
    const std::string sentence = "no two of the 3 tiles have an edge in common: there are no seams; ";
    EXPECT_THAT(runs.check.out, HasSubstr("note           " + sentence));
    EXPECT_THAT(runs.flatten.err, HasSubstr("Note: " + sentence));
}

TEST(PartsApart, AreANoteOfBoth) {
    const Workshop workshop;
    std::vector<NamedMesh> tiles = sheets(0);
    tiles.push_back(sheets(8)[1]);
    tiles.back().name = "vent";
    workshop.write_tiles("sheets.obj", tiles);
    const Runs runs = expect_both_end_with(workshop, "sheets.obj --unit m", 0);
    EXPECT_THAT(runs.check.out, HasSubstr("note           tile vent at (9.50, 0.50, 0.00) m is sewn to nothing; "));
    EXPECT_THAT(runs.flatten.err, HasSubstr("Note: tile vent at (9.50, 0.50, 0.00) m is sewn to nothing; "));
}

}  // namespace faults_test
}  // namespace ripstop
