#include <gmock/gmock.h>
#include <gtest/gtest.h>

#ifdef RIPSTOP_CAD_PROGRAM

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>

#include "cad/cad_files.h"
#include "ripstop/base/error.h"
#include "ripstop/io/mesh/mesh_file.h"
#include "ripstop/pipeline/read/read_envelope.h"
#include "support/outside.h"
#include "support/program.h"
#include "support/shared_data.h"

namespace ripstop {
namespace cad_test {

using ::testing::AllOf;
using testing::area_of;
using ::testing::Each;
using ::testing::HasSubstr;
using testing::read_cad;
using testing::ScratchDirectory;
using testing::Workshop;

std::string fault_of(const std::string& file, MeshingOptions options = {}) {
    if (options.mesher.empty()) options.mesher = RIPSTOP_CAD_PROGRAM;
    try {
        read_model(file, options);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

/// A stand-in for `ripstop-cad`.
std::string script(const ScratchDirectory& scratch, const std::string& body) {
    const std::string path = scratch.path("mesher.sh");
    testing::write_text(path, "#!/bin/sh\n" + body + "\n");
    std::filesystem::permissions(path, std::filesystem::perms::owner_all);
    return path;
}

TEST(Cad, TheSameCubeInInchMillimetreAndMetreIsTheSameCube) {
    const ScratchDirectory scratch;
    for (const std::string extension : {".step", ".iges"})
        for (const auto& [writers, ours] : {std::pair("MM", "mm"), std::pair("INCH", "in"), std::pair("M", "m")}) {
            SCOPED_TRACE(extension + " in " + ours);
            const std::string file = scratch.path(std::string("cube_") + ours + extension);
            testing::write_cube(file, writers);
            CadModel model = read_cad(file);
            ASSERT_TRUE(model.unit.has_value());
            EXPECT_EQ(model.unit->name, ours);
            const double metres = model.unit->metres;
            model = in_metres(std::move(model), metres);
            EXPECT_EQ(model.surfaces.size(), 6U);
            EXPECT_NEAR(area_of(model), 6, 1e-9);
            for (const NamedMesh& surface : model.surfaces) {
                EXPECT_EQ(surface.name.rfind("cube_0", 0), 0U) << surface.name;
                EXPECT_GE(surface.mesh.positions.minCoeff(), -1e-9);
                EXPECT_LE(surface.mesh.positions.maxCoeff(), 1 + 1e-9);
                // Outward: away from the centre of the cube.
                EXPECT_GT(area_vector(surface.mesh).dot(centroid(surface.mesh) - Vec3(0.5, 0.5, 0.5)), 0.4);
            }
        }
}

TEST(Cad, ABrepSaysNoUnitAndIsTakenAsAsked) {
    const ScratchDirectory scratch;
    testing::write_cube(scratch.path("cube.brep"), "MM");
    EXPECT_FALSE(read_cad(scratch.path("cube.brep")).unit.has_value());
    ReadOptions options{.unit = LengthUnit{"mm", 0.001}};
    options.meshing.mesher = RIPSTOP_CAD_PROGRAM;
    options.meshing.edge_length = 0.25;
    const Envelope envelope = read_envelope(scratch.path("cube.brep"), options);
    ASSERT_EQ(envelope.tiles.size(), 6U);
    EXPECT_EQ(envelope.seams.size(), 12U);
    EXPECT_NEAR(surface_area(envelope.tiles[0].mesh), 1, 1e-9);
    // Edges of a quarter metre on a square of one metre: about 40 triangles, not thousands.
    EXPECT_LT(envelope.tiles[0].mesh.triangle_count(), 100);
}

TEST(Cad, TheFacesOfRealFilesHaveTheAreaBoundaryAndBoxThatOpenCascadeSays) {
    for (const std::string name : {"base_interface_AP203", "base_interface_AP214", "featuretype"}) {
        RIPSTOP_REQUIRE_SHARED(source, ("step/" + name + ".STEP"));
        SCOPED_TRACE(name);
        const testing::CadFigures figures = testing::step_figures(source.string());
        CadModel model = read_cad(source.string(), {.chord_error = 1e-5, .edge_length = 2e-3});
        const double metres = model.unit.value_or(LengthUnit{}).metres;
        model = in_metres(std::move(model), metres);
        ASSERT_EQ(model.surfaces.size(), figures.faces.size());
        Vec3 low = model.surfaces[0].mesh.positions.row(0), high = low;
        for (std::size_t i = 0; i < figures.faces.size(); ++i) {
            const TriangleMesh& mesh = model.surfaces[i].mesh;
            // A chord error of 0.01 mm along all edges, times two for holes and rounding.
            EXPECT_NEAR(surface_area(mesh), figures.faces[i].area, 2e-5 * figures.faces[i].boundary) << i;
            low = low.cwiseMin(mesh.positions.colwise().minCoeff().transpose());
            high = high.cwiseMax(mesh.positions.colwise().maxCoeff().transpose());
        }
        EXPECT_LT((low - figures.low).norm() + (high - figures.high).norm(), 1e-4);
    }
}

TEST(Cad, NeighboursShareTheVerticesOfTheirSeam) {
    const ScratchDirectory scratch;
    for (const std::string name : {"gores.step", "gores.iges"}) {
        SCOPED_TRACE(name);
        testing::write_gores(scratch.path(name), 8);
        ReadOptions options;
        options.meshing.mesher = RIPSTOP_CAD_PROGRAM;
        const EnvelopeInput input = read_input(scratch.path(name), options);
        EXPECT_EQ(input.unit.unit.name, "mm");
        EXPECT_EQ(input.envelope.tiles.at(0).name, "G01");
        ASSERT_EQ(input.envelope.seams.size(), 8U);
        for (const Seam& seam : input.envelope.seams) {
            EXPECT_EQ(seam.gap, 0) << "edges of one seam lie apart";
        }
        // An inscribed polyline that turns by 2.8 degrees per edge is too short by 0.01 %.
        EXPECT_THAT(input.remarks, ::testing::Contains(HasSubstr("short of its curves")));
    }
}

TEST(Cad, AGoredEnvelopeIsSoundAndItsSeamsMatchWhenFlattened) {
    const Workshop workshop;
    testing::write_gores(workshop.path("gores.step"), 12);
    const auto check = workshop.ripstop("check gores.step --json");
    EXPECT_EQ(check.code, 0) << check.err;
    const auto flat = workshop.ripstop("flatten gores.step -o out --quiet");
    EXPECT_LE(flat.code, 1) << flat.err;
    const auto report = nlohmann::json::parse(workshop.read("out/report.json"));
    ASSERT_EQ(report.at("seams").size(), 12U);
    for (const auto& seam : report["seams"]) EXPECT_LE(std::abs(seam.at("mismatch_pct").get<double>()), 0.001);
}

TEST(Cad, PartsOfAnAssemblyStandInTheirPlacesWithNamesOfTheirOwn) {
    const ScratchDirectory scratch;
    testing::write_assembly(scratch.path("assembly.step"));
    CadModel model = in_metres(read_cad(scratch.path("assembly.step")), 0.001);
    ASSERT_EQ(model.surfaces.size(), 2U);
    EXPECT_EQ(model.surfaces[0].name, "panel");
    EXPECT_EQ(model.surfaces[1].name, "panel_2");
    EXPECT_LT((centroid(model.surfaces[0].mesh) - Vec3(1, 0.5, 0)).norm(), 1e-9);
    EXPECT_LT((centroid(model.surfaces[1].mesh) - Vec3(1, 5, 0.5)).norm(), 1e-9);
}

TEST(Cad, PartsInOtherFilesAreReadBesideItOrNamed) {
    const ScratchDirectory scratch;
    testing::write_assembly_of_files(scratch.path("assembly.step"));
    ASSERT_TRUE(std::filesystem::exists(scratch.path("panel.stp")));
    CadModel model = in_metres(read_cad(scratch.path("assembly.step")), 0.001);
    ASSERT_EQ(model.surfaces.size(), 2U);
    EXPECT_LT((centroid(model.surfaces[0].mesh) - Vec3(1, 0.5, 0)).norm(), 1e-9);
    EXPECT_LT((centroid(model.surfaces[1].mesh) - Vec3(1, 5, 0.5)).norm(), 1e-9);
    EXPECT_TRUE(model.unread.empty());

    testing::write_text(scratch.path("panel.stp"), "ISO-10303-21; garbage");
    ASSERT_EQ(read_cad(scratch.path("assembly.step")).unread.size(), 1U);
    EXPECT_THAT(read_cad(scratch.path("assembly.step")).unread[0].reason,
                HasSubstr("panel.stp, which could not be read"));
    std::filesystem::remove(scratch.path("panel.stp"));
    model = read_cad(scratch.path("assembly.step"));
    EXPECT_TRUE(model.surfaces.empty());
    ASSERT_EQ(model.unread.size(), 1U);
    EXPECT_EQ(model.unread[0].name, "panel");
    EXPECT_THAT(model.unread[0].reason, HasSubstr("it lies in the file panel.stp, which is not beside this one"));
}

TEST(Cad, WhatTheKernelDoesNotKnowBesideAShapeIsLeftOutAndNamesStay) {
    const ScratchDirectory scratch;
    const std::string file = scratch.path("cube.step");
    testing::write_cube(file, "MM");
    std::string text = testing::content(file);
    const std::string items = "ADVANCED_BREP_SHAPE_REPRESENTATION('',(";
    ASSERT_NE(text.find(items), std::string::npos);
    text.insert(text.find(items) + items.size(), "#900000,");
    text.insert(text.rfind("ENDSEC;"), "#900000 = SOME_NEW_ITEM('');\n");
    testing::write_text(file, text);
    const CadModel model = read_cad(file);
    ASSERT_EQ(model.surfaces.size(), 6U);
    EXPECT_EQ(model.surfaces[0].name, "cube_01");
    EXPECT_NEAR(area_of(in_metres(model, 0.001)), 6, 1e-9);
    EXPECT_THAT(model.remarks, ::testing::Contains(HasSubstr("1 item other than shapes left out")));
    EXPECT_THAT(model.remarks, ::testing::Contains(HasSubstr("1 SOME_NEW_ITEM")));
}

TEST(Cad, NeighboursThatFaceOppositeWaysAreMadeToAgreeAndItIsSaid) {
    const ScratchDirectory scratch;
    testing::write_opposed(scratch.path("opposed.brep"));
    const CadModel model = read_cad(scratch.path("opposed.brep"));
    ASSERT_EQ(model.surfaces.size(), 2U);
    for (const NamedMesh& surface : model.surfaces) EXPECT_GT(area_vector(surface.mesh).z(), 0) << surface.name;
    EXPECT_THAT(model.remarks, ::testing::Contains(HasSubstr("1 face was turned over")));
}

TEST(Cad, TheFacesOfAnObjectAreOneTileWhereAsked) {
    const Workshop workshop;
    testing::write_cube(workshop.path("cube.step"), "MM");
    EXPECT_THAT(workshop.ripstop("inspect cube.step --tiles objects").out, HasSubstr("surfaces       1\n"));
    const auto closed = workshop.ripstop("check cube.step --tiles objects");
    EXPECT_EQ(closed.code, 3);
    EXPECT_THAT(closed.err, HasSubstr("cube"));
}

TEST(Cad, AFaceSewnToItselfIsNoTileAndAFileWithoutFacesHasNone) {
    const Workshop workshop;
    testing::write_tube(workshop.path("tube.step"));
    testing::write_line(workshop.path("line.step"));
    const auto tube = workshop.ripstop("check tube.step"), line = workshop.ripstop("check line.step");
    EXPECT_EQ(tube.code, 3);
    EXPECT_THAT(tube.err, HasSubstr("tube: has 2 boundary loops"));
    EXPECT_EQ(line.code, 3);
    EXPECT_THAT(line.err, HasSubstr("no surface that could be read"));
    EXPECT_EQ(read_cad(workshop.path("line.step")).curves.at(0).name, "GRAIN");
}

TEST(Cad, AsFineAsAskedAndNoFinerThanCanBeBorne) {
    const ScratchDirectory scratch;
    testing::write_gores(scratch.path("gores.step"), 8);
    const auto triangles = [&](const MeshingOptions& options) {
        int sum = 0;
        for (const NamedMesh& surface : read_cad(scratch.path("gores.step"), options).surfaces)
            sum += surface.mesh.triangle_count();
        return sum;
    };
    // The chord error is quadratic in the edge length: a quarter of it takes four times as many triangles.
    const double ratio = static_cast<double>(triangles({.chord_error = 4e-3, .edge_length = 10})) /
                         triangles({.chord_error = 16e-3, .edge_length = 10});
    EXPECT_NEAR(ratio, 4, 1);
    EXPECT_THAT(fault_of(scratch.path("gores.step"), {.edge_length = 1e-3}), HasSubstr("million triangles"));
    EXPECT_THAT(fault_of(scratch.path("gores.step"), {.edge_length = 0.0}), HasSubstr("--edge"));
}

TEST(Cad, NoSurfaceLiesFurtherOffItsTrianglesThanAsked) {
    const ScratchDirectory scratch;
    for (const std::string name : {"gores.step", "gores.iges"}) {
        testing::write_gores(scratch.path(name), 4);
        for (const double chord_error : {40e-3, 15e-3}) {
            const CadModel model = read_cad(scratch.path(name), {.chord_error = chord_error});
            const double found = testing::greatest_distance(scratch.path(name), model);
            EXPECT_LE(found, chord_error * (1 + 1e-6)) << name;
            EXPECT_GT(found, chord_error / 4) << name << ": far finer than asked";
            EXPECT_THAT(model.remarks, Each(::testing::Not(HasSubstr("no mesh can reach"))));
        }
    }
}

TEST(Cad, ACoordinateThatIsNoneOrIsFarOffIsRefused) {
    const ScratchDirectory scratch;
    for (const std::string extension : {".step", ".iges"})
        for (const std::string number : {"NaN", "1.E300"}) {
            SCOPED_TRACE(extension + " with " + number);
            const std::string file = scratch.path("wild" + extension);
            testing::write_cube(file, "MM");
            std::string text = testing::content(file);
            if (extension == ".step") {
                const std::string point = "CARTESIAN_POINT('',(0.,";
                text.replace(text.find(point) + point.size() - 3, 2, number);
            } else {
                // The new first parameter has as many columns as the old one, 1000.
                const std::size_t at = text.rfind("1.E+03");
                ASSERT_NE(at, std::string::npos);
                text.replace(at, 6, number == "NaN" ? "   NaN" : "1.D300");
            }
            testing::write_text(file, text);
            EXPECT_THAT(fault_of(file),
                        AllOf(HasSubstr("wild" + extension), HasSubstr("expected a number below 1e12")));
        }
}

TEST(Cad, AFileCutShortIsRefusedWhereverItIsCut) {
    const ScratchDirectory scratch;
    for (const std::string extension : {".step", ".iges", ".brep"}) {
        testing::write_cube(scratch.path("whole" + extension), "MM");
        const std::string whole = testing::content(scratch.path("whole" + extension));
        for (std::size_t i = 0; i < 16; ++i) {
            SCOPED_TRACE(extension + " cut at sixteenth " + std::to_string(i));
            const std::string file = scratch.path("cut" + extension);
            testing::write_text(file, whole.substr(0, whole.size() * i / 16));
            const std::string fault = fault_of(file);
            EXPECT_THAT(fault, AllOf(::testing::StartsWith(file + ": not a"), HasSubstr("export")));
            EXPECT_EQ(fault.find("cut" + extension), fault.rfind("cut" + extension)) << "named twice: " << fault;
        }
    }
    testing::write_text(scratch.path("garbage.step"), "garbage");
    EXPECT_THAT(fault_of(scratch.path("garbage.step")), HasSubstr("not a whole STEP file"));
    EXPECT_THAT(fault_of(scratch.path("absent.step")), HasSubstr("cannot be opened"));
}

TEST(Cad, LengthsAreInTheFilesOwnNumbersWhereItSaysNoUnit) {
    const ScratchDirectory scratch;
    const std::string file = scratch.path("cube.brep");
    testing::write_cube(file, "MM");
    // A twelfth of 1000 units. Before, they were taken as metres, which gave 83333.3 mm.
    EXPECT_THAT(read_cad(file).remarks, ::testing::Contains(HasSubstr("edges of at most 83.3: at most 0.000 off")));
    EXPECT_THAT(read_cad(file, {.metres_per_unit = 0.001}).remarks,
                ::testing::Contains(HasSubstr("edges of at most 83.3 mm: at most 0.000 mm off")));
}

TEST(Cad, TellsTheFaceThatIsMeshed) {
    const ScratchDirectory scratch;
    const std::string file = scratch.path("cube.step");
    testing::write_cube(file, "MM");
    std::vector<std::string> told;
    MeshingOptions options{.mesher =
                               script(scratch, "echo progress 12 160 face >&2; echo 'ripstop-cad: no' >&2; exit 3")};
    options.progress = [&told](double share, const std::string& what) {
        EXPECT_EQ(share, 12 / 160.0);
        told.push_back(what);
    };
    EXPECT_THAT(fault_of(file, options), ::testing::EndsWith("cube.step: no"));
    EXPECT_THAT(told, ::testing::ElementsAre("face 12 of 160"));
    // By the program itself.
    told.clear();
    options.mesher.clear();
    options.progress = [&told](double, const std::string& what) { told.push_back(what); };
    read_cad(file, options);
    ASSERT_FALSE(told.empty());
    EXPECT_THAT(told.front(), ::testing::EndsWith(" of 6"));
}

TEST(Cad, NothingGoesOnOrIsLeftWhereRipstopIsKilled) {
    const Workshop workshop;
    const ScratchDirectory scratch;
    testing::write_cube(workshop.path("cube.step"), "MM");
    std::filesystem::create_directory(workshop.path("tmp"));
    const std::string mesher = script(scratch, "echo $$ > '" + workshop.path("new") + "'; mv '" + workshop.path("new") +
                                                   "' '" + workshop.path("pid") + "'; exec sleep 60");
    const std::string started = "cd '" + workshop.path("") + "'; TMPDIR=tmp RIPSTOP_CAD='" + mesher + "' '" +
                                testing::tested_program() + "' inspect cube.step >/dev/null 2>&1 & ";
    const std::string wait = "n=0; while [ $n -lt 1000 ] && ! { ";
    const std::string asked = "; }; do sleep 0.01; n=$((n+1)); done; ";
    const auto run = testing::run_command(started + wait + "[ -e pid ]" + asked +
                                          "kill -KILL $!; child=$(cat pid); [ -n \"$child\" ] || exit 9; " + wait +
                                          "! kill -0 $child 2>/dev/null || grep -q ') Z' /proc/$child/stat" + asked +
                                          "[ $n -lt 1000 ] && ls tmp | wc -l");
    EXPECT_EQ(run.output, "0\n") << "a process or a file is left";
}

TEST(Cad, WhateverBecomesOfTheMesherIsOneSentence) {
    const ScratchDirectory scratch;
    const std::string file = scratch.path("cube.step");
    testing::write_cube(file, "MM");
    const auto fault = [&](const std::string& body, double timeout = 60) {
        return fault_of(file, {.timeout = timeout, .mesher = script(scratch, body)});
    };
    EXPECT_THAT(fault("kill -KILL $$"), HasSubstr("crashed"));
    EXPECT_THAT(fault("for last; do :; done; echo rubbish > \"$last\""), HasSubstr("not a converted model"));
    EXPECT_THAT(fault("exit 0"), HasSubstr("gave no answer"));
    EXPECT_THAT(fault("echo 'ripstop-cad: it is round' >&2; exit 3"), ::testing::EndsWith("cube.step: it is round"));
    EXPECT_THAT(fault("exit 4"), HasSubstr("failed on it"));
    EXPECT_THAT(fault("sleep 60", 0.2), HasSubstr("did not end within 0.2 s"));
    EXPECT_THAT(fault_of(file, {.mesher = "/nowhere/ripstop-cad"}), HasSubstr("cannot be started"));
    const Workshop workshop;
    testing::write_cube(workshop.path("cube.step"), "MM");
    ::setenv("RIPSTOP_CAD", "/nowhere/ripstop-cad", 1);
    EXPECT_EQ(workshop.ripstop("check cube.step").code, 3);
    ::unsetenv("RIPSTOP_CAD");
}

}  // namespace cad_test
}  // namespace ripstop

#endif
