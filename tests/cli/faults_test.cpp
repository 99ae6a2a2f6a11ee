/// What `flatten` does with an envelope that is itself wrong.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "support/program.h"
#include "support/shapes.h"

namespace ripstop {
namespace faults_test {

using ::testing::HasSubstr;
using testing::ProgramRun;
using testing::Workshop;

/// Three sheets of 1 m x 1 m side by side, each `gap` beyond the one before.
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

}  // namespace faults_test
}  // namespace ripstop
