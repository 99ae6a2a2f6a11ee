/// Rhino files through `ripstop flatten`.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include <Eigen/Geometry>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "ripstop/base/text/number_text.h"
#include "ripstop/design/natural/gores.h"
#include "ripstop/io/mesh/obj.h"
#include "support/program.h"
#include "support/rhino.h"
#include "support/sanitized.h"

namespace ripstop {
namespace rhino_test {

using ::testing::HasSubstr;
using testing::ProgramRun;
using testing::Workshop;
using Json = nlohmann::json;

constexpr int gores = 12, panels = 3;
constexpr double inch = 0.0254;

/// The first gore of a balloon in inches, in single precision, as Rhino 4 and older store it.
std::vector<NamedMesh> gore() {
    EnvelopeDesign design;
    design.gores = gores;
    design.panels = panels;
    design.volume = 600;
    design.edge_length = 0.6;
    std::vector<NamedMesh> tiles = design_natural(design);
    tiles.resize(panels);
    for (NamedMesh& tile : tiles)
        tile.mesh.positions = (tile.mesh.positions / inch).cast<float>().cast<double>().eval();
    return tiles;
}

Eigen::Matrix4d turn(int which) {
    Eigen::Affine3d map = Eigen::Affine3d::Identity();
    map.linear() = Eigen::AngleAxisd(2 * std::numbers::pi * which / gores, Vec3::UnitZ()).toRotationMatrix();
    return map.matrix();
}

/// A grain line along the panel's height that leans to one side: a warp that no default would give.
std::array<Vec3, 2> grain_line(const NamedMesh& panel) {
    const Points3& p = panel.mesh.positions;
    const Vec3 middle = centroid(panel.mesh);
    Eigen::Index nearest = 0, far = 0;
    (p.rowwise() - middle.transpose()).rowwise().norm().minCoeff(&nearest);
    double best = 0;
    for (Eigen::Index v = 0; v < p.rows(); ++v) {
        const Vec3 way = (p.row(v) - p.row(nearest)).transpose();
        const double score = way.norm() < 25 ? way.z() + 0.3 * way.y() : 0;  // 25 inches: still on the surface
        if (score > best) {
            best = score;
            far = v;
        }
    }
    return {p.row(nearest), p.row(far)};
}

Json rows(const auto& matrix) {
    Json json = Json::array();
    for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
        json.push_back(Json::array());
        for (Eigen::Index k = 0; k < matrix.cols(); ++k) json.back().push_back(matrix(i, k));
    }
    return json;
}

/// Eleven gores are rotated instances of a block. The last gore is meshes without names, each on its own layer.
Json scene_of(const std::vector<NamedMesh>& gore) {
    Json scene = {{"unit", "Inches"}, {"layers", {{{"name", "Gores"}}, {{"name", "Grain"}}}}};
    Json parts = Json::array(), objects = Json::array();
    for (int i = 0; i < panels; ++i) {
        const auto& [name, mesh, drawn, warp, attributes, fault] = gore[static_cast<std::size_t>(i)];
        const std::string part = fmt::format("P{}", i + 1);
        parts.push_back({{"kind", "mesh"},
                         {"name", part},
                         {"layer", 0},
                         {"vertices", rows(mesh.positions)},
                         {"faces", rows(mesh.triangles)}});
        const auto line = grain_line(gore[static_cast<std::size_t>(i)]);
        parts.push_back(
            {{"kind", "line"}, {"layer", 1}, {"points", {rows(line[0].transpose())[0], rows(line[1].transpose())[0]}}});
        const Eigen::Matrix4d place = turn(gores - 1);
        const Points3 moved = mesh.positions * place.topLeftCorner<3, 3>().transpose();
        scene["layers"].push_back({{"name", fmt::format("G12{}", part)}});
        objects.push_back(
            {{"kind", "mesh"}, {"layer", 2 + i}, {"vertices", rows(moved)}, {"faces", rows(mesh.triangles)}});
        Points3 ends(2, 3);
        ends << line[0].transpose(), line[1].transpose();
        objects.push_back({{"kind", "line"},
                           {"layer", 1},
                           {"points", rows(Points3(ends * place.topLeftCorner<3, 3>().transpose()))}});
    }
    scene["definitions"] = {{{"name", "gore"}, {"objects", parts}}};
    for (int g = 0; g + 1 < gores; ++g) {
        Json map = Json::array();
        for (const Json& row : rows(turn(g))) map.insert(map.end(), row.begin(), row.end());
        objects.push_back({{"kind", "block"},
                           {"definition", "gore"},
                           {"name", fmt::format("G{}", g + 1)},
                           {"layer", 0},
                           {"xform", map}});
    }
    scene["objects"] = objects;
    return scene;
}

struct Twin {
    std::vector<NamedMesh> tiles;
    Json project = {{"unit", "in"}, {"tiles", Json::array()}};
};

/// The same tiles in the order of the Rhino file, with warps from a project. `single`: meshes outside of blocks
/// lose their double precision.
Twin twin_of(const std::vector<NamedMesh>& gore, bool single) {
    Twin twin;
    std::vector<int> order = {gores - 1};
    for (int g = 0; g + 1 < gores; ++g) order.push_back(g);
    for (const int g : order)
        for (int i = 0; i < panels; ++i) {
            const bool in_block = g + 1 < gores;
            const std::string part = fmt::format("P{}", i + 1);
            NamedMesh tile = gore[static_cast<std::size_t>(i)];
            tile.name = in_block ? fmt::format("G{}/{}", g + 1, part) : fmt::format("G12{}", part);
            const Eigen::Matrix3d map = turn(g).topLeftCorner<3, 3>();
            tile.mesh.positions = (tile.mesh.positions * map.transpose()).eval();
            if (single && !in_block) tile.mesh.positions = tile.mesh.positions.cast<float>().cast<double>().eval();
            const auto line = grain_line(gore[static_cast<std::size_t>(i)]);
            const Vec3 way = map * (line[1] - line[0]);
            twin.project["tiles"].push_back(
                {{"name", tile.name}, {"warp", {{"direction", {way.x(), way.y(), way.z()}}}}});
            twin.tiles.push_back(std::move(tile));
        }
    return twin;
}

/// Expects equal texts and numbers (to 1e-9 of their size), except for the source of the warp and run times.
void expect_same(const Json& a, const Json& b, const std::string& place) {
    if (a.is_number() && b.is_number()) {
        // Places are equal up to rounding; figures are equal up to the solver's response to that rounding.
        EXPECT_NEAR(a.get<double>(), b.get<double>(), 1e-9 * (1 + std::abs(b.get<double>()))) << place;
        return;
    }
    ASSERT_EQ(a.type(), b.type()) << place;
    ASSERT_EQ(a.size(), b.size()) << place;
    if (a.is_object()) {
        for (const auto& [key, value] : a.items())
            // If a drift is as small as rounding, its largest place is chance.
            if (key != "grain" && key != "seconds" && key != "iterations" && key != "drift_max_at_mm")
                expect_same(value, b.value(key, Json()), place + "." + key);
    } else if (a.is_array()) {
        for (std::size_t i = 0; i < a.size(); ++i) expect_same(a[i], b[i], fmt::format("{}[{}]", place, i));
    } else {
        EXPECT_EQ(a, b) << place;
    }
}

TEST(RhinoFlatten, GivesTheCutPlanOfItsObjTwinInEveryVersion) {
    RIPSTOP_TOO_LONG_SANITIZED();
    RIPSTOP_REQUIRE_RHINO();
    const Workshop workshop;
    const std::vector<NamedMesh> tiles = gore();
    testing::write_by_rhino(scene_of(tiles), workshop.path("envelope.json"), {3, 4, 5, 6, 7, 8});
    std::map<bool, Json> reports;
    std::map<bool, std::map<std::string, std::string>> flat;
    for (const bool single : {true, false}) {
        const Twin twin = twin_of(tiles, single);
        workshop.write_tiles("twin.obj", twin.tiles);
        workshop.write("twin.json", twin.project.dump());
        const ProgramRun run = workshop.ripstop("flatten twin.obj --project twin.json --quiet --force -o twin");
        ASSERT_LE(run.code, 1) << run.err;
        reports[single] = Json::parse(workshop.read("twin/report.json"));
        flat[single] = workshop.files("twin/flat");
    }
    for (const int version : {3, 4, 5, 6, 7, 8}) {
        const bool single = version < 5;
        const std::string file = fmt::format("envelope_v{}.3dm", version);
        const ProgramRun run = workshop.ripstop("flatten " + file + " --quiet --force -o plan");
        ASSERT_LE(run.code, 1) << run.err;
        const Json report = Json::parse(workshop.read("plan/report.json"));
        EXPECT_EQ(report["input"]["unit"], "in");
        ASSERT_EQ(report["tiles"].size(), static_cast<std::size_t>(gores * panels)) << file;
        for (const Json& tile : report["tiles"]) EXPECT_EQ(tile["grain"]["source"], "grain line") << tile["name"];
        for (const char* key : {"tiles", "seams"}) expect_same(report[key], reports[single][key], file + " " + key);
        const auto files = workshop.files("plan/flat");
        ASSERT_EQ(files.size(), flat[single].size());
        for (const auto& [name, text] : files) {
            if (name == "sewing.json") continue;  // contains the name of the plan's file
            std::istringstream a(text), b(flat[single][name]);
            const CadModel ours = read_obj(a, name), other = read_obj(b, name);
            // To a nanometre; the file is in millimetres.
            EXPECT_LT((ours.surfaces.at(0).mesh.positions - other.surfaces.at(0).mesh.positions).cwiseAbs().maxCoeff(),
                      1e-6)
                << file << " " << name;
        }
    }
}

TEST(RhinoFlatten, SaysWhatItLeavesOutAndTakesLayersByName) {
    const Workshop workshop;
    const std::string file = RIPSTOP_SOURCE_DIR "/tests/data/rhino/tiles_v8.3dm";
    const ProgramRun run = workshop.ripstop("flatten " + file + " --layer 'Gores::*' --force -o plan");
    EXPECT_LE(run.code, 1) << run.err;
    EXPECT_THAT(run.err, HasSubstr("1 hidden object left out"));
    const Json report = Json::parse(workshop.read("plan/report.json"));
    ASSERT_EQ(report["tiles"].size(), 1u);
    EXPECT_EQ(report["tiles"][0]["name"], "G01P01");
}

TEST(RhinoFlatten, SaysWhyItsSurfacesAreNotReadWhereNodeIsMissing) {
    const std::string path = ::getenv("PATH");
    ::setenv("PATH", "/nowhere", 1);
    const ProgramRun run = Workshop().ripstop("check " RIPSTOP_SOURCE_DIR "/tests/data/rhino/curves_v8.3dm");
    ::setenv("PATH", path.c_str(), 1);
    EXPECT_EQ(run.code, 3);
    EXPECT_THAT(run.err, HasSubstr("rhino3dm (node) cannot be started"));
}

TEST(RhinoFlatten, NamesALayerWhoseSurfacesLieBelowIt) {
    const ProgramRun run =
        Workshop().ripstop("check " RIPSTOP_SOURCE_DIR "/tests/data/rhino/tiles_v8.3dm --layer Default");
    EXPECT_EQ(run.code, 3);
    EXPECT_THAT(run.err, HasSubstr("give \"Default::*\" for the layers below it"));
}

TEST(RhinoFlatten, NamesWhatIsThereWhereNoSurfaceIs) {
    ::setenv("RIPSTOP_CAD", "/nowhere/ripstop-cad", 1);  // no extrusion can be read then
    const ProgramRun run = Workshop().ripstop("flatten " RIPSTOP_SOURCE_DIR "/tests/data/rhino/curves_v8.3dm -o plan");
    ::unsetenv("RIPSTOP_CAD");
    EXPECT_EQ(run.code, 3);
    EXPECT_THAT(run.err, HasSubstr("no surface that could be read"));
    EXPECT_THAT(run.err, HasSubstr("Extrusion wall: an extrusion is not read; mesh it in Rhino"));
}

}  // namespace rhino_test
}  // namespace ripstop
