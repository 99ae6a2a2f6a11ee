/// Files with defects that every CAD mends on import, and files with a tile that cannot be mended.
#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>

#include "ripstop/io/mesh/mesh_file.h"
#include "support/program.h"
#include "support/shapes.h"

namespace ripstop {
namespace mendable_files_test {

using std::numbers::pi;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::ProgramRun;
using testing::Workshop;
using Json = nlohmann::json;

/// Expects `check` and `flatten` to exit alike; returns flatten's messages, including notes.
std::string both_end(const Workshop& workshop, const std::string& arguments, int code) {
    const ProgramRun check = workshop.ripstop("check " + arguments);
    const ProgramRun flatten = workshop.ripstop("flatten " + arguments + " --force -o plan");
    EXPECT_EQ(check.code, code) << arguments << "\n" << check.out << check.err;
    EXPECT_EQ(flatten.code, code) << arguments << "\n" << flatten.out << flatten.err;
    return flatten.err + flatten.out;
}

const std::string corners = "o T\nv 0 0 0\nv 1 0 0\nv 1 1 0.1\nv 0 1 0\n";

TEST(MendableFiles, AFaceThatNamesACornerTwiceIsATriangle) {
    const Workshop workshop;
    workshop.write("sheet.obj", corners + "f 1 2 3 3\nf 1 3 4 4\n");
    EXPECT_THAT(both_end(workshop, "sheet.obj --unit m", 0), HasSubstr("1 of 1 tile manufacturable"));
}

TEST(MendableFiles, ATriangleWithoutAreaGoesWithANote) {
    const Workshop workshop;
    workshop.write("pole.obj", corners + "v 0 1 0\nf 1 2 3\nf 1 3 4\nf 4 3 5\n");
    const std::string pole = both_end(workshop, "pole.obj --unit m", 0);
    EXPECT_THAT(pole,
                HasSubstr("Note: 1 vertex merged with another in the same place: in T, near (0.0000, 1.0000, 0.0000)"));
    EXPECT_THAT(pole, HasSubstr("Note: 1 triangle without area removed: in T"));
    workshop.write("needle.obj", corners + "v 0.5 0.5 0.05\nf 1 2 3\nf 1 3 5\nf 1 5 4\nf 5 3 4\n");
    EXPECT_THAT(both_end(workshop, "needle.obj --unit m", 0), HasSubstr("Note: 1 triangle without area removed"));
    workshop.write("twice.obj", corners + "f 1 2 3\nf 1 3 4\nf 3 2 1\nf 1 2 3\n");
    EXPECT_THAT(both_end(workshop, "twice.obj --unit m", 0),
                HasSubstr("Note: 2 triangles that coincided with another removed"));
}

/// A gore of the unit sphere as a grid of quads whose first and last rows of vertices coincide in the poles.
std::vector<NamedMesh> gores_with_poles(int count) {
    std::vector<NamedMesh> gores;
    for (int g = 0; g < count; ++g) {
        TriangleMesh mesh = testing::grid(2, 12, [&](double u, double v) {
            const double lat = pi * (v - 0.5), lon = 2 * pi * (g + u) / count;
            return Vec3(5 * std::cos(lat) * std::cos(lon), 5 * std::cos(lat) * std::sin(lon), 5 * std::sin(lat));
        });
        for (int i = 0; i <= 2; ++i) {
            mesh.positions.row(i) << 0, 0, -5;
            mesh.positions.row(36 + i) << 0, 0, 5;
        }
        gores.push_back({std::string("G").append(std::to_string(g)), mesh, {}});
    }
    return gores;
}

TEST(MendableFiles, RowsOfVerticesAtThePolesAreJoinedInEveryFormat) {
    const Workshop workshop;
    for (const MeshFormat& format : mesh_formats()) {
        if (!format.write) continue;
        const std::string file = std::string("gores") + format.extension;
        std::ofstream out(workshop.path(file));
        format.write(out, gores_with_poles(12));
        out.close();
        const ProgramRun run = workshop.ripstop("check " + file + " --unit m");
        EXPECT_EQ(run.code, 0) << file << run.out << run.err;
        EXPECT_THAT(run.out, HasSubstr("tiles          12, ")) << file;
        EXPECT_THAT(run.out, HasSubstr("seams          12, ")) << file;
        EXPECT_THAT(run.out, HasSubstr("open edges     none: the envelope is closed")) << file;
    }
}

TEST(MendableFiles, TipsOfWhichEachTriangleHasItsOwnAreWelded) {
    const Workshop workshop;
    std::vector<NamedMesh> gores = gores_with_poles(24);
    for (NamedMesh& gore : gores)  // as left by an exporter that drops triangles without area and does nothing else
        for (int t = gore.mesh.triangle_count() - 1; t >= 0; --t) {
            Triangles& triangles = gore.mesh.triangles;
            bool flat = false;
            for (int k = 0; k < 3; ++k) flat = flat || gore.mesh.corner(t, k) == gore.mesh.corner(t, (k + 1) % 3);
            if (!flat) continue;
            triangles.row(t) = triangles.row(triangles.rows() - 1).eval();
            triangles.conservativeResize(triangles.rows() - 1, 3);
        }
    workshop.write_tiles("gores.obj", gores);
    const std::string said = both_end(workshop, "gores.obj --unit m --fabric nylon", 0);
    EXPECT_THAT(said,
                HasSubstr("Note: 48 vertices of tips, separate for each triangle, welded: in G0, G1, G2 and 21 more"));
    EXPECT_THAT(said, HasSubstr("24 of 24 tiles manufacturable"));
    EXPECT_THAT(workshop.ripstop("check gores.obj --unit m").out, Not(HasSubstr("cracks")));
}

TEST(MendableFiles, ACrackThatMayBeADartIsSewnAndSaidToBe) {
    const Workshop workshop;
    TriangleMesh mesh = testing::rectangle(2, 1, 8, 8);
    for (int j = 0; j < 4; ++j) {
        const int v = 9 * j + 4;
        mesh.positions.conservativeResize(mesh.positions.rows() + 1, 3);
        mesh.positions.row(mesh.positions.rows() - 1) = mesh.positions.row(v).eval();
        for (int t = 0; t < mesh.triangle_count(); ++t) {
            const bool right =
                (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)).x() / 3 > mesh.positions(v, 0);
            for (int k = 0; k < 3; ++k)
                if (right && mesh.triangles(t, k) == v) mesh.triangles(t, k) = mesh.vertex_count() - 1;
        }
    }
    workshop.write_tiles("dart.obj", {{"dart", mesh, {}}});
    const ProgramRun run = workshop.ripstop("check dart.obj --unit m");
    EXPECT_EQ(run.code, 0) << run.out;
    EXPECT_THAT(run.out, HasSubstr("1 seam within a tile is a crack with no gap (dart): sewn as a closed dart"));
}

TEST(BadTiles, AreListedAndTheOthersMade) {
    const Workshop workshop;
    std::string text =
        "o frame\nv 0 0 0\nv 3 0 0\nv 3 3 0\nv 0 3 0\nv 1 1 0\nv 2 1 0\nv 2 2 0\nv 1 2 0\n"
        "f 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n"
        "o bow\nf 1 3 2 4\n";
    for (int i = 0; i < 5; ++i) {
        const std::string x = std::to_string(3 + i), next = std::to_string(4 + i);
        text += "o sheet" + std::to_string(i) + "\nv " + x + " 0 0\nv " + next + " 0 0\nv " + next + " 1 0\nv " + x +
                " 1 0\nf -4 -3 -2 -1\n";
    }
    workshop.write("some.obj", text);
    const std::string said = both_end(workshop, "some.obj --unit m", 1);
    EXPECT_THAT(said, HasSubstr("tile frame: has 2 boundary loops"));
    EXPECT_THAT(said, HasSubstr("tile bow: some.obj:15: a face with 4 corners folds over itself"));
    EXPECT_THAT(said, HasSubstr("it is left out, and the edges of its neighbours along it count as free"));
    const Json report = Json::parse(workshop.read("plan/report.json"));
    EXPECT_EQ(report["tiles"].size(), 5u);
    for (const Json& tile : report["tiles"]) EXPECT_TRUE(tile["verdict"]["manufacturable"]);
    EXPECT_FALSE(report["envelope"]["manufacturable"]);
    ASSERT_EQ(report["envelope"]["findings"].size(), 2u);
    EXPECT_EQ(report["envelope"]["findings"][0]["code"], "no_tile");
    EXPECT_EQ(report["envelope"]["failed"], Json::array({"frame", "bow"}));
    const Json check = Json::parse(workshop.ripstop("check some.obj --unit m --json").out);
    EXPECT_EQ(check["issues"][0]["code"], "no_tile");
    EXPECT_EQ(check["issues"][0]["tiles"], Json::array({"frame"}));
    both_end(workshop, "some.obj --unit m --tile 'sheet*'", 0);
}

TEST(BadTiles, AloneAreRefused) {
    const Workshop workshop;
    workshop.write("bow.obj", corners + "f 1 3 2 4\n");
    EXPECT_THAT(both_end(workshop, "bow.obj --unit m", 3), HasSubstr("tile T: bow.obj:6: a face with 4 corners folds"));
}

}  // namespace mendable_files_test
}  // namespace ripstop
