/// The unit, size and position of a file: `flatten` refuses what `check` calls wrong, before it starts the work.
#include <gmock/gmock.h>

#include <cstdint>
#include <nlohmann/json.hpp>
#include <sstream>

#include "ripstop/design/natural/gores.h"
#include "ripstop/io/mesh/obj.h"
#include "support/mesh_text.h"
#include "support/program.h"
#include "support/sanitized.h"
#include "support/shapes.h"

namespace ripstop {
namespace unit_test {

using ::testing::HasSubstr;
using ::testing::Not;
using testing::ProgramRun;
using testing::Workshop;
using Json = nlohmann::json;

std::vector<NamedMesh> small_balloon() {
    EnvelopeDesign design;
    design.gores = 8;
    design.panels = 2;
    design.volume = 600;
    design.edge_length = 0.8;
    return design_natural(design);
}

struct Ends {
    ProgramRun check, flatten;
};

Ends both_end(const Workshop& workshop, const std::string& arguments, int code, const std::string& formats = "dxf") {
    Ends ends{workshop.ripstop("check " + arguments),
              workshop.ripstop("flatten " + arguments + " --remesh never --format " + formats + " --force -o plan")};
    EXPECT_EQ(ends.check.code, code) << arguments << "\n" << ends.check.out << ends.check.err;
    EXPECT_EQ(ends.flatten.code, code) << arguments << "\n" << ends.flatten.out << ends.flatten.err;
    return ends;
}

TEST(WrongUnit, EndsWith1AndTheUnitIsNamedFirst) {
    const Workshop workshop;
    workshop.write("sheet.obj", "o SHEET\nv 0 0 0\nv 300 0 0\nv 300 300 20\nv 0 300 0\nf 1 2 3\nf 1 3 4\n");
    const std::string sentence =
        "the envelope measures 300 m, a hot-air balloon is 5 to 60 m tall; with --unit cm it "
        "would measure 3.00 m, with in 7.62 m; give --size-is-meant if this size is right";
    const Ends ends = both_end(workshop, "sheet.obj --unit m", 1);
    EXPECT_THAT(ends.check.out, HasSubstr("WRONG          " + sentence));
    EXPECT_THAT(ends.flatten.err, ::testing::StartsWith("Warning: " + sentence));
    const Json report = Json::parse(workshop.read("plan/report.json"));
    EXPECT_FALSE(report["envelope"]["manufacturable"]);
    ASSERT_EQ(report["envelope"]["findings"].size(), 1u);
    EXPECT_EQ(report["envelope"]["findings"][0]["code"], "unit");
    EXPECT_EQ(report["envelope"]["findings"][0]["limit"], 100000);
    both_end(workshop, "sheet.obj --unit m --tile SHEET", 1);
    both_end(workshop, "sheet.obj --unit cm", 0);
}

TEST(WrongUnit, OfMillimetresAsMetresIsSaidBeforeThePaperRunsOut) {
    RIPSTOP_TOO_LONG_SANITIZED();
    const Workshop workshop;
    workshop.write_tiles("balloon.obj", small_balloon(), 1000);
    const Ends ends = both_end(workshop, "balloon.obj --unit m", 1, "dxf,pdf");
    const std::string& said = ends.flatten.err;
    EXPECT_THAT(said, HasSubstr("with --unit mm it would measure 1"));
    ASSERT_THAT(said, HasSubstr("Warning: no PDF is written: "));
    EXPECT_LT(said.find("with --unit mm"), said.find("no PDF is written"));
    EXPECT_TRUE(workshop.files("plan").contains("cut/envelope.dxf"));
    EXPECT_FALSE(workshop.files("plan").contains("cut/envelope.pdf"));
    EXPECT_EQ(workshop.ripstop("check balloon.obj --unit mm").code, 0);
}

TEST(WrongUnit, IsNotDoubtedWhereTheSizeIsMeant) {
    const Workshop workshop;
    workshop.write("roof.obj", "o ROOF\nv 0 0 0\nv 120 0 0\nv 120 90 0\nv 0 90 0\nf 1 2 3\nf 1 3 4\n");
    both_end(workshop, "roof.obj --unit m", 1);
    both_end(workshop, "roof.obj --unit m --size-is-meant", 0);
    workshop.write("roof.json", R"({"unit": "m", "size_is_meant": true})");
    both_end(workshop, "roof.obj --project roof.json", 0);
}

TEST(WrongUnit, OfTheFileItselfIsWrongTooUntilOneIsGiven) {
    const Workshop workshop;
    workshop.write("sheet.ply",
                   "ply\nformat ascii 1.0\ncomment unit m\nelement vertex 3\nproperty double x\nproperty double y\n"
                   "property double z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
                   "0 0 0\n2000 0 0\n0 1500 0\n3 0 1 2\n");
    const Ends ends = both_end(workshop, "sheet.ply", 1);
    EXPECT_THAT(ends.flatten.err, HasSubstr("in the file's own unit, m, a hot-air balloon"));
    both_end(workshop, "sheet.ply --unit mm", 0);
}

/// The tiles shifted to map coordinates, with all digits of a double.
std::vector<NamedMesh> on_the_map(std::vector<NamedMesh> tiles, const Vec3& by) {
    for (NamedMesh& tile : tiles) tile.mesh.positions.rowwise() += by.transpose();
    return tiles;
}

TEST(FarOrigin, GivesThePatternsOfTheSameEnvelopeAtTheOrigin) {
    const Workshop workshop;
    const Vec3 utm(500000, 5000000, 0);
    workshop.write_tiles("here.obj", small_balloon());
    workshop.write_tiles("there.obj", on_the_map(small_balloon(), utm));
    const std::string options = " --unit m --fabric nylon --remesh never --propose none --format dxf --force -o plan";
    const int code = workshop.ripstop("flatten here.obj" + options).code;
    const auto here = workshop.files("plan/flat");
    const ProgramRun far = workshop.ripstop("flatten there.obj" + options);
    EXPECT_EQ(far.code, code);
    EXPECT_THAT(far.err, HasSubstr("Note: the model lies 5024938 m from the origin; all positions are relative to "
                                   "(500000, 5000000, 0) m"));
    const auto there = workshop.files("plan/flat");
    ASSERT_EQ(here.size(), there.size());
    for (const auto& [name, text] : here) {
        if (!name.ends_with(".obj")) continue;
        std::istringstream a(text), b(there.at(name));
        const Points2 flat = *read_obj(a, name).surfaces.at(0).drawn, same = *read_obj(b, name).surfaces.at(0).drawn;
        EXPECT_LT((flat - same).cwiseAbs().maxCoeff(), 1e-6) << name;
    }
}

TEST(FarOrigin, MovesThePointsOfTheProjectToo) {
    const Workshop workshop;
    NamedMesh sheet{"sheet", testing::rectangle(2, 1, 4, 2), {}};
    workshop.write_tiles("sheet.obj", on_the_map({sheet}, {500000, 5000000, 0}));
    workshop.write("project.json", R"({"tiles": [{"name": "S", "at": [500001, 5000000.5, 0],
        "corners": [[500000, 5000000, 0], [500002, 5000000, 0], [500002, 5000001, 0]]}]})");
    const Json report = Json::parse(workshop.ripstop("check sheet.obj --unit m --project project.json --json").out);
    EXPECT_EQ(report["corners"], 3);
}

TEST(FarOrigin, OfSinglePrecisionIsToldWhatItLost) {
    const Workshop workshop;
    const auto stl = [&](const std::string& file, const Vec3& by) {
        const TriangleMesh mesh = on_the_map({{"s", testing::rectangle(2, 1, 4, 2), {}}}, by)[0].mesh;
        std::string bytes(80, ' ');
        bytes += testing::bytes_of<std::uint32_t>({static_cast<std::uint32_t>(mesh.triangle_count())});
        for (int t = 0; t < mesh.triangle_count(); ++t) {
            bytes += testing::bytes_of<float>({0, 0, 1});
            for (int k = 0; k < 3; ++k)
                for (const double x : mesh.corner(t, k)) bytes += testing::bytes_of<float>({static_cast<float>(x)});
            bytes += std::string(2, '\0');
        }
        workshop.write(file, bytes);
    };
    stl("near.stl", {10, 10, 0});
    EXPECT_THAT(both_end(workshop, "near.stl --unit m", 0).flatten.err, Not(HasSubstr("single precision")));
    stl("far.stl", {2000, 1000, 0});
    EXPECT_THAT(
        both_end(workshop, "far.stl --unit m", 0).flatten.err,
        HasSubstr("Note: coordinates are stored in single precision: 0.061 mm of rounding error at this distance from "
                  "the origin"));
    stl("map.stl", {500000, 500000, 0});
    const Ends ends = both_end(workshop, "map.stl --unit m", 1);
    EXPECT_THAT(ends.check.out,
                HasSubstr("WRONG          coordinates are stored in single precision: 15.6 mm of "
                          "rounding error at this distance from the origin, more than the seam tolerance"));
    EXPECT_EQ(Json::parse(workshop.read("plan/report.json"))["envelope"]["findings"][0]["code"], "precision");
}

}  // namespace unit_test
}  // namespace ripstop
