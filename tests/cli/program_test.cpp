/// The program as a shell sees it: exit codes, what goes where, what is left behind.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <sys/wait.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "ripstop/flatten/method.h"
#include "ripstop/io/obj.h"
#include "support/outside.h"
#include "support/shapes.h"

namespace ripstop {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

struct Ended {
    int code = -1;
    std::string out, err;
};

std::string text_of(const fs::path& file) {
    return testing::content(file.string());
}

class Program : public ::testing::Test {
  protected:
    testing::ScratchDirectory scratch;

    fs::path at(const std::string& name) const { return scratch.path(name); }

    Ended run(const std::string& arguments) const {
        const std::string command =
            "cd '" + scratch.path() + "' && '" RIPSTOP_PROGRAM "' " + arguments + " >out.txt 2>err.txt </dev/null";
        const int status = std::system(command.c_str());
        return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text_of(at("out.txt")), text_of(at("err.txt"))};
    }

    void write(const std::string& name, const std::string& text) const {
        testing::write_text(scratch.path(name), text);
    }

    void write_tiles(const std::string& name, const std::vector<NamedMesh>& tiles) const {
        std::ofstream out(at(name), std::ios::binary);
        write_obj(out, tiles);
    }

    std::vector<NamedMesh> two_cylinders() const {
        const TriangleMesh mesh = testing::cylinder(1, 1.2, 2, 6, 6);
        return {{"left", mesh, {}}, {"right side", testing::moved(mesh), {}}};
    }

    bool nothing_left_of(const std::string& directory) const {
        for (const auto& entry : fs::directory_iterator(scratch.path()))
            if (entry.path().filename().string().rfind(directory, 0) == 0) return false;
        return true;
    }
};

TEST_F(Program, EndsWith0WhereEveryTileCanBeMadeAndWritesThePlanOfTheContract) {
    write_tiles("tiles.obj", two_cylinders());
    const Ended ended = run("flatten tiles.obj --unit m -o plan");
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_THAT(ended.out, HasSubstr("2 of 2 tiles manufacturable"));
    EXPECT_THAT(ended.err, HasSubstr("100 % done"));
    for (const char* file : {"report.json", "tiles.csv", "flat/left.obj", "flat/right_side.obj", "cut/envelope.dxf",
                             "cut/envelope.svg", "cut/tiles/left.dxf", "cut/tiles/right_side.svg", "pictures/left.svg"})
        EXPECT_TRUE(fs::exists(at("plan") / file)) << file;
}

TEST_F(Program, EndsWith1WhereATileCannotBeMadeAndWritesEverythingAllTheSame) {
    write_tiles("tiles.obj", {{"quarter", testing::lune(1.5707963, 10, 20), {}}});
    const Ended ended = run("flatten tiles.obj -o plan --quiet");
    EXPECT_EQ(ended.code, 1);
    EXPECT_THAT(ended.out, IsEmpty());
    EXPECT_THAT(ended.err, IsEmpty());
    const std::string report = text_of(at("plan/report.json"));
    EXPECT_THAT(report, HasSubstr("\"code\": \"area\""));
    EXPECT_TRUE(fs::exists(at("plan/cut/tiles/quarter.dxf")));
}

TEST_F(Program, EndsWith2ForUsage) {
    write_tiles("tiles.obj", two_cylinders());
    EXPECT_EQ(run("").code, 2);
    EXPECT_EQ(run("flatten").code, 2);
    EXPECT_EQ(run("flatten tiles.obj -o plan --nonsense").code, 2);
    EXPECT_EQ(run("flatten tiles.obj -o plan --unit ell").code, 2);
    EXPECT_EQ(run("flatten tiles.obj -o plan --method paper --keep-area").code, 2);
    const Ended ended = run("flatten tiles.obj -o plan --method foo");
    EXPECT_EQ(ended.code, 2);
    EXPECT_THAT(ended.err, HasSubstr("no method \"foo\"; known: seam-exact"));
    EXPECT_TRUE(nothing_left_of("plan"));
}

TEST_F(Program, EndsWith3AndOneSentenceForInputThatCannotBeUsed) {
    const auto refused = [&](const std::string& arguments, const std::string& said) {
        const Ended ended = run("flatten " + arguments + " -o plan");
        EXPECT_EQ(ended.code, 3) << arguments;
        EXPECT_THAT(ended.err, HasSubstr(said)) << arguments;
        EXPECT_THAT(ended.out, IsEmpty());
        EXPECT_TRUE(nothing_left_of("plan"));
    };
    refused("missing.obj", "missing.obj");
    write("tiles.xyz", "1 2 3\n");
    refused("tiles.xyz", ".obj");
    write("broken.obj", "v 0 0 0\nv 1 0 0\nv 0 nan 0\nf 1 2 3\n");
    refused("broken.obj", "broken.obj:3");
    write("points.obj", "v 0 0 0\nv 1 0 0\n");
    refused("points.obj", "points.obj");
    TriangleMesh holed = testing::rectangle(3, 3, 3, 3);
    Triangles kept(16, 3);
    kept << holed.triangles.topRows(8), holed.triangles.bottomRows(8);
    holed.triangles = kept;
    write_tiles("holed.obj", {{"vent", holed, {}}});
    refused("holed.obj", "tile vent: has 2 boundary loops");
    write_tiles("tiles.obj", two_cylinders());
    refused("tiles.obj --fabric silk", "isotropic, nylon");
    refused("tiles.obj --tile 'G*'", "left, right side");
    write("shop.json", "{\"warps\": 1}");
    refused("tiles.obj --project shop.json", "warps");
}

TEST_F(Program, LeavesAFolderThatIsNotEmptyAloneUnlessForced) {
    write_tiles("tiles.obj", two_cylinders());
    fs::create_directory(at("plan"));
    write("plan/mine.txt", "precious");
    EXPECT_EQ(run("flatten tiles.obj -o plan").code, 3);
    EXPECT_FALSE(fs::exists(at("plan/report.json")));
    EXPECT_EQ(run("flatten tiles.obj -o plan --force").code, 0);
    EXPECT_EQ(text_of(at("plan/mine.txt")), "precious");
    EXPECT_EQ(run("flatten tiles.obj -o nowhere/plan").code, 3);
}

TEST_F(Program, PrintsTheReportOnStdoutWhereAsked) {
    write_tiles("tiles.obj", two_cylinders());
    const Ended ended = run("flatten tiles.obj -o plan --json --reproducible");
    EXPECT_EQ(ended.out, text_of(at("plan/report.json")));
}

TEST_F(Program, GivesTheSameBytesOnAnyNumberOfThreads) {
    std::vector<NamedMesh> tiles;
    for (int i = 0; i < 6; ++i) tiles.push_back({fmt::format("T{}", i), testing::lune(0.2 + 0.05 * i, 4, 12), {}});
    write_tiles("tiles.obj", tiles);
    for (const std::string method : {"seam-exact", "paper"}) {
        run("flatten tiles.obj -o one --force --reproducible --jobs 1 --method " + method);
        run("flatten tiles.obj -o two --force --reproducible --jobs 2 --method " + method);
        for (const char* file : {"report.json", "tiles.csv", "flat/T3.obj", "cut/envelope.dxf", "pictures/T5.svg"})
            EXPECT_EQ(text_of(at("one") / file), text_of(at("two") / file)) << method << " " << file;
    }
}

TEST_F(Program, MillimetresOfOneFileAreMetresOfTheOther) {
    std::vector<NamedMesh> tiles = two_cylinders();
    write_tiles("m.obj", tiles);
    for (NamedMesh& tile : tiles) tile.mesh.positions *= 1000;
    write_tiles("mm.obj", tiles);
    run("flatten m.obj -o metres --unit m");
    run("flatten mm.obj -o millimetres --unit mm");
    const auto figures = [&](const std::string& plan) {
        std::istringstream lines(text_of(at(plan + "/tiles.csv")));
        std::string header, row;
        std::getline(lines, header);
        std::getline(lines, row);
        return row.substr(0, row.find(",true,") + 12);
    };
    EXPECT_EQ(figures("metres"), figures("millimetres"));
    EXPECT_THAT(run("flatten m.obj -o assumed").err, HasSubstr("taken as metres"));
}

TEST_F(Program, TakesWarpCornersFabricUnitAndCompensationFromTheProject) {
    TriangleMesh sheet = testing::rectangle(2000, 1000, 8, 4);
    write_tiles("sheet.obj", {{"sheet", sheet, {}}});
    write("shop.json", R"({"unit": "mm", "fabric": "nylon",
        "tiles": [{"name": "sh*", "warp": {"from": [0, 0, 0], "to": [0, 500, 0]}, "compensation": {"warp_pct": 1}}]})");
    const Ended ended = run("flatten sheet.obj --project shop.json -o plan");
    EXPECT_EQ(ended.code, 0) << ended.err;
    const std::string report = text_of(at("plan/report.json"));
    EXPECT_THAT(report, HasSubstr("\"name\": \"nylon\""));
    EXPECT_THAT(report, HasSubstr("shop.json, tile \\\"sh*\\\""));
    // the warp runs along the short side, which is cut one per cent longer: 2 x 1.01 m2
    EXPECT_THAT(report, HasSubstr("\"flat_area_m2\": 2.02"));
}

TEST_F(Program, JudgesFlatPositionsOfOthers) {
    NamedMesh tile{"square", testing::rectangle(1, 1, 4, 4), {}};
    tile.drawn = Points2(tile.mesh.positions.leftCols(2) * 1.01);
    write_tiles("drawn.obj", {tile});
    const Ended ended = run("flatten drawn.obj --method given -o plan");
    EXPECT_EQ(ended.code, 1);
    EXPECT_THAT(text_of(at("plan/report.json")), HasSubstr("\"perimeter_error_pct\": 1.0"));
    tile.drawn.reset();
    write_tiles("plain.obj", {tile});
    EXPECT_EQ(run("flatten plain.obj --method given -o other").code, 3);
}

TEST_F(Program, HoldsTheAreaWhereAsked) {
    write_tiles("tile.obj", {{"gore", testing::lune(0.4, 6, 24), {}}});
    run("flatten tile.obj --keep-area -o plan");
    EXPECT_THAT(text_of(at("plan/report.json")), HasSubstr("\"method\": \"seam-exact-area\""));
    EXPECT_THAT(text_of(at("plan/report.json")), HasSubstr("\"area_error_pct\": 0.0"));
}

TEST_F(Program, ListsEveryMethodAndItsVersion) {
    const Ended listed = run("methods");
    for (const Method& method : methods()) EXPECT_THAT(listed.out, HasSubstr(method.origin));
    const Ended shown = run("--version");
    EXPECT_EQ(shown.code, 0);
    EXPECT_THAT(shown.out, StartsWith("ripstop "));
}

TEST_F(Program, DrawsABalloonAndRefusesAnImpossibleOne) {
    const Ended drawn = run("design natural --gores 8 --panels 3 --volume 100 --edge 400mm -o b.obj");
    EXPECT_EQ(drawn.code, 0) << drawn.err;
    EXPECT_THAT(drawn.out, HasSubstr("24 tiles"));
    EXPECT_THAT(drawn.out, Not(HasSubstr("WRONG")));
    EXPECT_EQ(run("design natural -o b.obj").code, 3);  // exists
    const Ended refused = run("design natural --gores 2 -o c.obj");
    EXPECT_EQ(refused.code, 3);
    EXPECT_THAT(refused.err, HasSubstr("gores"));
    EXPECT_EQ(run("design natural --edge 5 -o c.obj").code, 3);  // a length without a unit
    EXPECT_TRUE(nothing_left_of("c.obj"));
}

}  // namespace
}  // namespace ripstop
