#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "ripstop/flatten/method.h"
#include "ripstop/io/mesh/obj.h"
#include "ripstop/remesh/remesh_disk.h"
#include "ripstop/report/page/page_template.h"
#include "support/program.h"

namespace ripstop {
namespace flatten_test {

using Json = nlohmann::json;
using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using testing::ProgramRun;
using ::testing::StartsWith;
using testing::Workshop;

Json report_of(const Workshop& workshop, const std::string& plan) {
    return Json::parse(workshop.read(plan + "/report.json"));
}

/// Runs `ripstop flatten ARGUMENTS` and returns its report.
Json flattened(const Workshop& workshop, const std::string& arguments) {
    const ProgramRun run = workshop.ripstop("flatten --force --quiet -o plan " + arguments);
    EXPECT_LE(run.code, 1) << arguments << ": " << run.err;
    return run.code <= 1 ? report_of(workshop, "plan") : Json();
}

std::vector<std::string> tile_names(const Json& report) {
    std::vector<std::string> names;
    for (const Json& tile : report["tiles"]) names.push_back(tile["name"]);
    return names;
}

/// The width along the warp and the height along the weft of a flat piece [m].
Vec2 flat_size(const Workshop& workshop, const std::string& file) {
    std::ifstream in(workshop.path(file), std::ios::binary);
    const Points2 flat = read_obj(in, file).surfaces.at(0).drawn.value();
    return (flat.colwise().maxCoeff() - flat.colwise().minCoeff()).transpose();
}

void expect_size(const Workshop& workshop, double width, double height) {
    EXPECT_NEAR(flat_size(workshop, "plan/flat/plane.obj").x(), width, 1e-9);
    EXPECT_NEAR(flat_size(workshop, "plan/flat/plane.obj").y(), height, 1e-9);
}

TEST(FlattenCommand, PrintsTheResultOnStdoutAndTheProgressOnStderr) {
    const Workshop workshop;
    workshop.write_tiles("envelope.obj", {testing::flat_tile(), testing::curved_tile()});
    const ProgramRun run = workshop.ripstop("flatten envelope.obj -o plan");
    EXPECT_THAT(run.out, StartsWith("tile "));
    EXPECT_THAT(run.out, HasSubstr("\nplane "));
    EXPECT_THAT(run.out, HasSubstr("  no: area, "));
    EXPECT_THAT(run.out, EndsWith("\nplan\n"));
    EXPECT_THAT(run.out, Not(HasSubstr("done")));
    EXPECT_THAT(run.err, HasSubstr(" 50 % done, "));
    EXPECT_THAT(run.err, HasSubstr("100 % done, "));
    EXPECT_THAT(run.err, Not(HasSubstr("\r"))) << "a bar where there is no terminal";
}

TEST(FlattenCommand, SaysWhatSizeFollowsWhereNoUnitIsGiven) {
    const Workshop workshop;
    workshop.write_tiles("envelope.obj", {testing::flat_tile()});
    EXPECT_THAT(workshop.ripstop("flatten envelope.obj -o a").err,
                HasSubstr("so metres are assumed: the envelope measures 2 x 1 x 0 m"));
    EXPECT_THAT(workshop.ripstop("flatten envelope.obj -o b --unit m").err, Not(HasSubstr("metres are assumed")));
}

TEST(FlattenCommand, PrintsTheReportsBytesForMachines) {
    const Workshop workshop;
    workshop.write_tiles("envelope.obj", {testing::flat_tile(), testing::curved_tile()});
    const ProgramRun run = workshop.ripstop("flatten envelope.obj -o plan --json");
    EXPECT_EQ(run.out, workshop.read("plan/report.json"));
    EXPECT_TRUE(Json::accept(run.out));
    const ProgramRun quiet = workshop.ripstop("flatten envelope.obj -o quiet --json --quiet --reproducible");
    EXPECT_EQ(quiet.out, workshop.read("quiet/report.json"));
    EXPECT_THAT(quiet.err, IsEmpty());
}

TEST(FlattenCommand, PrintsNothingWhenQuiet) {
    const Workshop workshop;
    workshop.write_tiles("envelope.obj", {testing::flat_tile(), testing::curved_tile()});
    const ProgramRun run = workshop.ripstop("flatten envelope.obj -o plan --quiet");
    EXPECT_EQ(run.code, 1);
    EXPECT_THAT(run.out, IsEmpty());
    EXPECT_THAT(run.err, IsEmpty());
}

TEST(FlattenCommand, LaysThePlanOutAsTheContractSays) {
    const Workshop workshop;
    workshop.write_tiles("envelope.obj", {testing::flat_tile("G01P01"), testing::bent_tile("Bílý dráček/2")});
    ASSERT_EQ(workshop.ripstop("flatten envelope.obj -o plan").code, 0);
    std::vector<std::string> written;
    for (const auto& [name, bytes] : workshop.files("plan")) {
        EXPECT_THAT(bytes, Not(IsEmpty())) << name;
        written.push_back(name);
    }
    if (page_template().empty()) written.insert(written.end() - 3, "report.html");  // built without Node.js
    EXPECT_THAT(written, ElementsAre("bom.csv", "cut/envelope.dxf", "cut/envelope.pdf", "cut/envelope.svg",
                                     "cut/pieces.json", "cut/tiles/Bily_dracek_2.dxf", "cut/tiles/Bily_dracek_2.svg",
                                     "cut/tiles/G01P01.dxf", "cut/tiles/G01P01.svg", "flat/Bily_dracek_2.obj",
                                     "flat/G01P01.obj", "flat/sewing.json", "pictures/Bily_dracek_2.svg",
                                     "pictures/G01P01.svg", "report.html", "report.json", "seams.csv", "tiles.csv"));
    EXPECT_THAT(workshop.names(), ElementsAre("envelope.obj", "plan"));
    const Json report = report_of(workshop, "plan");
    EXPECT_THAT(tile_names(report), ElementsAre("G01P01", "Bílý dráček/2"));
    EXPECT_EQ(report["tiles"][1]["file"], "Bily_dracek_2");
    EXPECT_EQ(report["input"]["file"], "envelope.obj");
}

TEST(FlattenCommand, WritesAReportThatItsSchemaAccepts) {
    const std::string python = testing::python_with("jsonschema");
    if (python.empty()) GTEST_SKIP() << "no Python with jsonschema here";
    const Workshop workshop;
    workshop.write_tiles("envelope.obj", {testing::flat_tile(), testing::curved_tile("a\"b")});
    workshop.write("validate.py",
                   "import json, sys, jsonschema\n"
                   "schema, *reports = (json.load(open(name)) for name in sys.argv[1:])\n"
                   "for report in reports: jsonschema.Draft202012Validator(schema).validate(report)\n");
    workshop.ripstop("flatten envelope.obj -o a");
    workshop.ripstop("flatten envelope.obj -o b --reproducible --fabric nylon --grain 12.5");
    const auto result = testing::run_command(python + " " + workshop.path("validate.py") +
                                             " " RIPSTOP_SOURCE_DIR "/docs/report.schema.json " +
                                             workshop.path("a/report.json") + " " + workshop.path("b/report.json"));
    EXPECT_EQ(result.code, 0) << result.output;
}

TEST(FlattenCommand, ProposesASeamForATileThatCannotBeMade) {
    const Workshop workshop;
    workshop.write_tiles("envelope.obj", {testing::flat_tile("flat"), testing::curved_tile("quarter")});
    const ProgramRun run = workshop.ripstop("flatten envelope.obj -o plan");
    EXPECT_EQ(run.code, 1);
    EXPECT_THAT(run.out, HasSubstr("quarter: of "));
    const Json tiles = report_of(workshop, "plan")["tiles"];
    EXPECT_FALSE(tiles[0].contains("proposal"));
    const Json& proposal = tiles[1]["proposal"];
    EXPECT_EQ(proposal["direction"], "along the warp");
    for (const Json& half : proposal["halves"])
        EXPECT_GT(half["area_error_pct"].get<double>(), 0.4 * tiles[1]["area_error_pct"].get<double>());
    EXPECT_EQ(workshop.ripstop("flatten envelope.obj -o without --propose none").code, 1);
    EXPECT_FALSE(report_of(workshop, "without")["tiles"][1].contains("proposal"));
    EXPECT_EQ(workshop.ripstop("flatten envelope.obj -o never --propose sometimes").code, 2);
}

TEST(FlattenCommand, LeavesNothingBehindWhenItFails) {
    const Workshop workshop;
    workshop.write_tiles("envelope.obj", {testing::flat_tile()});
    EXPECT_EQ(workshop.ripstop("flatten envelope.obj -o plan --method given").code, 3);
    EXPECT_EQ(workshop.ripstop("flatten envelope.obj -o plan --tile missing").code, 3);
    EXPECT_THAT(workshop.names(), ElementsAre("envelope.obj"));
}

TEST(FlattenCommand, GivesTheSameBytesOnAnyNumberOfThreads) {
    const Workshop workshop;
    workshop.write_tiles("envelope.obj", {testing::curved_tile("a"), testing::flat_tile("b"), testing::bent_tile("c"),
                                          testing::curved_tile("d"), testing::bent_tile("e")});
    for (const char* const jobs : {"1", "2", "3"})
        workshop.ripstop(std::string("flatten envelope.obj --reproducible -o jobs") + jobs + " --jobs " + jobs);
    EXPECT_EQ(workshop.files("jobs1"), workshop.files("jobs2"));
    EXPECT_EQ(workshop.files("jobs1"), workshop.files("jobs3"));
    EXPECT_EQ(workshop.files("jobs1").size(), page_template().empty() ? 29u : 30u);
    EXPECT_THAT(workshop.read("jobs1/report.json"), Not(HasSubstr("\"seconds\"")));
}

TEST(FlattenCommand, TakesOnlyTheTilesThatWereAskedFor) {
    const Workshop workshop;
    workshop.write_tiles("envelope.obj", {testing::flat_tile("G01P01"), testing::flat_tile("G01P02"),
                                          testing::flat_tile("G02P01"), testing::flat_tile("crown")});
    EXPECT_THAT(tile_names(flattened(workshop, "envelope.obj --tile 'G01*'")), ElementsAre("G01P01", "G01P02"));
    EXPECT_THAT(tile_names(flattened(workshop, "envelope.obj --tile 'G??P01'")), ElementsAre("G01P01", "G02P01"));
    EXPECT_THAT(tile_names(flattened(workshop, "envelope.obj --tile crown --tile G02P01")),
                ElementsAre("G02P01", "crown"));
    EXPECT_THAT(tile_names(flattened(workshop, "--tile crown envelope.obj")), ElementsAre("crown"))
        << "--tile has taken the input for a name";
    const ProgramRun run = workshop.ripstop("flatten envelope.obj -o none --tile crown --tile 'g01*'");
    EXPECT_EQ(run.code, 3);
    EXPECT_THAT(run.err, HasSubstr("no tile is called \"g01*\"; the input has G01P01, G01P02, G02P01, crown"));
}

TEST(FlattenCommand, ReadsTheSameSurfaceInAnyUnit) {
    const Workshop workshop;
    const std::vector<NamedMesh> tiles{testing::flat_tile(), testing::curved_tile()};
    workshop.write_tiles("m.obj", tiles);
    // Uses the input's own mesh, because a choice of the remesher may depend on the last bit of a coordinate.
    const Json metres = flattened(workshop, "m.obj --remesh never");
    for (const auto& [unit, per_metre] :
         {std::pair{"mm", 1000.0}, std::pair{"cm", 100.0}, std::pair{"in", 1 / 0.0254}, std::pair{"ft", 1 / 0.3048}}) {
        workshop.write_tiles("scaled.obj", tiles, per_metre);
        const Json scaled = flattened(workshop, std::string("scaled.obj --remesh never --unit ") + unit);
        EXPECT_EQ(scaled["input"]["unit"], unit);
        for (const std::size_t i : {0u, 1u})
            for (const char* const figure : {"area_m2", "flat_area_m2", "perimeter_mm"}) {
                const double expected = metres["tiles"][i][figure];
                // The coordinates are rounded once more; the paper's method propagates the 1e-16 through its
                // steps.
                EXPECT_NEAR(scaled["tiles"][i][figure].get<double>(), expected, 1e-6 * expected) << unit << figure;
            }
    }
}

TEST(FlattenCommand, TakesUnitFabricAndTolerancesFromTheProject) {
    const Workshop workshop;
    workshop.write_tiles("mm.obj", {testing::flat_tile(), testing::curved_tile()}, 1000);
    workshop.write("project.json", R"({"unit": "mm", "fabric": "nylon", "tolerances":
        {"area_pct": 50, "length_pct": 60, "strain_pct": 70, "shear_deg": 80}})");
    const Json report = flattened(workshop, "mm.obj --project project.json");
    EXPECT_EQ(report["input"]["unit"], "mm");
    EXPECT_NEAR(report["tiles"][0]["area_m2"], 2, 1e-12);
    EXPECT_EQ(report["fabric"]["name"], "nylon");
    EXPECT_EQ(report["tolerances"],
              Json::parse(R"({"area_pct": 50, "length_pct": 60, "strain_pct": 70, "shear_deg": 80})"));
    EXPECT_TRUE(report["envelope"]["manufacturable"]);
    const Json other = flattened(workshop, "mm.obj --project project.json --unit cm --fabric polyester");
    EXPECT_NEAR(other["tiles"][0]["area_m2"], 200, 1e-9) << "the command line goes before the project";
    EXPECT_EQ(other["fabric"]["name"], "polyester");
}

TEST(FlattenCommand, FindsTheFabricBesideTheProject) {
    const Workshop workshop;
    workshop.write_tiles("envelope.obj", {testing::flat_tile()});
    std::filesystem::create_directory(workshop.path("job"));
    workshop.write("job/silk.json", R"({"name": "silk", "warp_stiffness_n_per_m": 1000,
        "weft_stiffness_n_per_m": 2000, "shear_stiffness_n_per_m": 100})");
    workshop.write("job/project.json", R"({"fabric": "silk.json"})");
    EXPECT_EQ(flattened(workshop, "envelope.obj --project job/project.json")["fabric"]["name"], "silk");
}

TEST(FlattenCommand, LaysTheWarpAsTheProjectSays) {
    const Workshop workshop;
    workshop.write_tiles("envelope.obj", {testing::flat_tile()});
    flattened(workshop, "envelope.obj");
    expect_size(workshop, 2, 1);
    workshop.write("direction.json", R"({"tiles": [{"name": "p*", "warp": {"direction": [0, 3, 0]}}]})");
    const Json report = flattened(workshop, "envelope.obj --project direction.json");
    expect_size(workshop, 1, 2);
    EXPECT_EQ(report["tiles"][0]["grain"]["source"], "direction.json, tile \"p*\"");
    workshop.write("points.json", R"({"tiles": [{"name": "plane", "warp": {"from": [5, 1, 0], "to": [5, 9, 0]}}]})");
    flattened(workshop, "envelope.obj --project points.json");
    expect_size(workshop, 1, 2);
    flattened(workshop, "envelope.obj --project points.json --grain 30");
    expect_size(workshop, 1, 2);
}

TEST(FlattenCommand, LaysTheWarpAlongThePolylineCalledGrain) {
    const Workshop workshop;
    workshop.write(
        "envelope.obj",
        "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nv 1 0.1 0\nv 1 0.9 0\no plane\nf 1 2 3\nf 1 3 4\no GRAIN\nl 5 6\n");
    const Json report = flattened(workshop, "envelope.obj --unit m");
    expect_size(workshop, 1, 2);
    EXPECT_EQ(report["tiles"][0]["grain"]["source"], "grain line");
}

TEST(FlattenCommand, TakesUnitNamesAndWarpOfAPly) {
    const Workshop workshop;
    workshop.write(
        "envelope.ply",
        "ply\nformat ascii 1.0\ncomment unit mm\ncomment tile 4 plane\nelement vertex 4\nproperty float x\n"
        "property float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\n"
        "property int tile\nproperty float warp_x\nproperty float warp_y\nproperty float warp_z\nend_header\n"
        "0 0 0\n2000 0 0\n2000 1000 0\n0 1000 0\n4 0 1 2 3 4 0 1 0\n");
    const Json report = flattened(workshop, "envelope.ply");
    expect_size(workshop, 1, 2);
    EXPECT_EQ(report["tiles"][0]["grain"]["source"], "the file's warp of each triangle");
    EXPECT_EQ(report["input"]["unit"], "mm");
}

TEST(FlattenCommand, CutsTheChainsAtTheCornersOfTheProject) {
    const Workshop workshop;
    workshop.write_tiles("mm.obj", {testing::flat_tile()}, 1000);
    const auto lengths = [&](const std::string& options) {
        std::vector<double> result;
        const Json report = flattened(workshop, "mm.obj --unit mm " + options);
        for (const Json& chain : report["tiles"][0]["chains"])
            result.push_back(std::round(chain["length_mm"].get<double>()));
        return result;
    };
    EXPECT_THAT(lengths(""), ElementsAre(2000, 1000, 2000, 1000));
    workshop.write("project.json", R"({"tiles": [{"name": "plane", "corners": [[0, 0, 0], [2000, 0, 0]]}]})");
    EXPECT_THAT(lengths("--project project.json"), ElementsAre(2000, 4000));
}

TEST(FlattenCommand, WarnsOfNamesInTheProjectThatFitNoTile) {
    const Workshop workshop;
    NamedMesh beside = testing::flat_tile("b");
    beside.mesh.positions.col(0).array() += 2;
    workshop.write_tiles("envelope.obj", {testing::flat_tile("a"), beside});
    workshop.write("project.json", R"({"tiles": [{"name": "a", "warp": {"direction": [1, 0, 0]}},
        {"name": "typo", "warp": {"direction": [1, 0, 0]}}]})");
    const std::string warning = "project.json: no tile is called \"";
    const ProgramRun run = workshop.ripstop("flatten envelope.obj -o plan --project project.json");
    EXPECT_EQ(run.code, 0);
    EXPECT_THAT(run.err, HasSubstr(warning + "typo\""));
    EXPECT_THAT(run.err, Not(HasSubstr(warning + "a\"")));
    EXPECT_THAT(workshop.ripstop("flatten envelope.obj -o b --tile b --project project.json").err,
                Not(HasSubstr(warning)));
}

TEST(FlattenCommand, TurnsTheWarpByTheGrainSeenFromOutside) {
    const Workshop workshop;
    workshop.write_tiles("envelope.obj", {testing::flat_tile()});
    const Json report = flattened(workshop, "envelope.obj --grain 90");
    expect_size(workshop, 1, 2);
    EXPECT_EQ(report["tiles"][0]["grain"]["source"], "longest axis turned by 90 degrees");
    const Json slanted = flattened(workshop, "envelope.obj --grain 12.5");
    EXPECT_EQ(slanted["tiles"][0]["grain"]["source"], "longest axis turned by 12.5 degrees");
    EXPECT_NEAR(slanted["tiles"][0]["grain"]["direction"][1], std::sin(12.5 * M_PI / 180), 1e-9) << "clockwise";
}

TEST(FlattenCommand, SwapsWarpAndWeftWithTheGrainWhereTheMethodKnowsNoFabric) {
    const Workshop workshop;
    workshop.write_tiles("envelope.obj", {testing::curved_tile()});
    // The strains along and across differ because of the coarse mesh.
    const Json along = flattened(workshop, "envelope.obj --remesh never --method lscm")["tiles"][0];
    const Json across = flattened(workshop, "envelope.obj --remesh never --method lscm --grain 90")["tiles"][0];
    for (const char* const end : {"min", "max"}) {
        const std::string warp = std::string("warp_") + end + "_pct", weft = std::string("weft_") + end + "_pct";
        // The grain is projected onto each triangle, so the two mean directions are not exactly at a right angle.
        EXPECT_NEAR(along["strain"][warp].get<double>(), across["strain"][weft].get<double>(), 0.01) << end;
        EXPECT_NEAR(along["strain"][weft].get<double>(), across["strain"][warp].get<double>(), 0.01) << end;
    }
    EXPECT_GT(std::abs(along["strain"]["warp_max_pct"].get<double>() - along["strain"]["weft_max_pct"].get<double>()),
              0.1)
        << "both the same: nothing was shown";
    EXPECT_DOUBLE_EQ(along["area_error_pct"], across["area_error_pct"]);
}

TEST(FlattenCommand, JudgesThePositionsThatCameWithTheFile) {
    const Workshop workshop;
    NamedMesh tile = testing::flat_tile();
    tile.drawn = 1.01 * tile.mesh.positions.leftCols<2>();
    workshop.write_tiles("drawn.obj", {tile});
    const Json report = flattened(workshop, "drawn.obj --method given");
    EXPECT_EQ(report["tiles"][0]["method"], "given");
    EXPECT_NEAR(report["tiles"][0]["area_error_pct"], 2.01, 1e-9);
    EXPECT_NEAR(report["tiles"][0]["perimeter_error_pct"], 1, 1e-9);
    EXPECT_FALSE(report["envelope"]["manufacturable"]);
    EXPECT_TRUE(flattened(workshop, "drawn.obj --method paper")["envelope"]["manufacturable"])
        << "another method must not look at what was drawn";
}

TEST(FlattenCommand, RemeshesWhatIsTooCoarseAndSaysSo) {
    const Workshop workshop;
    workshop.write_tiles("envelope.obj", {testing::curved_tile(), testing::flat_tile()});
    const std::size_t before = static_cast<std::size_t>(testing::curved_tile().mesh.triangle_count());
    const Json never = flattened(workshop, "envelope.obj --reproducible --remesh never"), tile = never["tiles"][0];
    EXPECT_EQ(tile["triangles"], before);
    EXPECT_FALSE(tile.contains("remeshed"));
    if (!can_remesh()) GTEST_SKIP() << "built without CGAL";
    const Json automatic = flattened(workshop, "envelope.obj --reproducible");
    EXPECT_GT(automatic["tiles"][0]["triangles"], 1000);
    EXPECT_EQ(automatic["tiles"][0]["remeshed"]["triangles_before"], before);
    EXPECT_EQ(automatic["tiles"][0]["remeshed"]["reason"], "edges turn by up to 15 degrees");
    EXPECT_EQ(automatic["tiles"][1], never["tiles"][1]) << "a flat tile is left alone";
    EXPECT_THAT(automatic["input"]["remarks"][0].get<std::string>(), HasSubstr("tile sphere remeshed at "));
    const Json asked = flattened(workshop, "envelope.obj --remesh 250mm");
    EXPECT_EQ(asked["tiles"][1]["remeshed"]["edge_length_mm"], 250);
    EXPECT_EQ(workshop.ripstop("flatten envelope.obj -o p --remesh 250").code, 3) << "a length without a unit";
    EXPECT_EQ(workshop.ripstop("flatten envelope.obj -o p --remesh 0mm").code, 3);
    EXPECT_EQ(workshop.ripstop("flatten envelope.obj -o p --remesh often").code, 2);
    EXPECT_EQ(workshop.ripstop("flatten envelope.obj -o p --method given --remesh 50mm").code, 2);
    EXPECT_THAT(workshop.ripstop("flatten envelope.obj -o p --force").out, HasSubstr("1 of 2 tiles remeshed: "));
}

TEST(FlattenCommand, RunsEveryMethodThatTheProgramNames) {
    const Workshop workshop;
    workshop.write_tiles("envelope.obj", {testing::bent_tile()});
    for (const Method& method : methods()) {
        // A prism, which every method must flatten exactly. On another mesh, the cylinder is no prism.
        const Json report = flattened(workshop, std::string("envelope.obj --remesh never --method ") + method.name);
        EXPECT_EQ(report["tiles"][0]["method"], method.name);
        // this method is exact on planes only, see docs/methods/others.md
        if (std::string(method.name) == "kub10") continue;
        EXPECT_TRUE(report["envelope"]["manufacturable"]) << method.name;
    }
}

}  // namespace flatten_test
}  // namespace ripstop
