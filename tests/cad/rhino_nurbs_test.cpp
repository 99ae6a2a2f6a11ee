#include <gmock/gmock.h>
#include <gtest/gtest.h>

#ifdef RIPSTOP_CAD_PROGRAM

#include <filesystem>
#include <map>
#include <numbers>

#include "ripstop/io/mesh/mesh_file.h"
#include "support/outside.h"
#include "support/sanitized.h"
#include "support/shared_data.h"

namespace ripstop {
namespace rhino_nurbs_test {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::ScratchDirectory;

class RhinoNurbs : public ::testing::Test {
  protected:
    void SetUp() override {
        if (!std::filesystem::exists(RIPSTOP_SOURCE_DIR "/apps/rhino/node_modules")) GTEST_SKIP() << "no rhino3dm";
    }

    /// Reads a file made by tests/cad/nurbs.mjs.
    CadModel read(const std::string& kind, int version, const std::string& mesher = RIPSTOP_CAD_PROGRAM) {
        const std::string file = scratch_.path(kind + std::to_string(version) + ".3dm");
        const auto written = testing::run_command("node '" RIPSTOP_SOURCE_DIR "/tests/cad/nurbs.mjs' " + kind + " '" +
                                                  file + "' " + std::to_string(version) + " 2>&1");
        EXPECT_EQ(written.code, 0) << written.output;
        return read_model(file, {.mesher = mesher});
    }

    ScratchDirectory scratch_;
};

std::map<std::string, double> areas(const CadModel& model) {
    std::map<std::string, double> result;
    for (const NamedMesh& surface : model.surfaces) result[surface.name] = surface_area(surface.mesh);
    return result;
}

TEST_F(RhinoNurbs, BrepsSurfacesAndExtrusionsOfEveryVersionHaveTheirExactAreas) {
    RIPSTOP_TOO_LONG_SANITIZED();
    for (const int version : {4, 5, 6, 7, 8}) {
        SCOPED_TRACE(version);
        const CadModel model = read("all", version);
        EXPECT_THAT(model.unread, IsEmpty());
        auto area = areas(model);
        ASSERT_EQ(area.size(), 11U);
        for (int i = 1; i <= 6; ++i) EXPECT_NEAR(area["box_0" + std::to_string(i)], 1e6, 1e-3);
        // A polygon inscribed in a circle with turns of 2.8 degrees: at most 0.04 % less area, and never more.
        const double wall = 2 * std::numbers::pi * 500 * 2000, lid = std::numbers::pi * 500 * 500;
        EXPECT_NEAR(area["DRUM_01"] / wall, 1, 4e-4);
        EXPECT_NEAR(area["DRUM_02"] / lid, 1, 6e-4);
        EXPECT_NEAR(area["DRUM_03"] / lid, 1, 6e-4);
        EXPECT_NEAR(area["strip"], 7e5, 1e-3);
        EXPECT_NEAR(area["crown"], 1e6, 1e-3) << "the only surface on its layer has the layer's name";
        for (const NamedMesh& surface : model.surfaces)
            EXPECT_EQ(surface.attributes.count("k"), surface.name.rfind("DRUM", 0) == 0 ? 1U : 0U) << surface.name;
    }
}

TEST_F(RhinoNurbs, AStoredMeshIsTakenWhereItsAreaSaysOtherwise) {
    const CadModel model = read("stored", 8);
    auto area = areas(model);
    EXPECT_NEAR(area["true"], 1e6, 1e-3);
    EXPECT_NEAR(area["false"], 1.2e6, 1) << "stored in single precision";
    EXPECT_THAT(model.remarks,
                Contains(HasSubstr("false: its surface has -16.7 % more area than the mesh stored with it")));
}

TEST_F(RhinoNurbs, WithoutAMesherEverySurfaceIsNamedAndItIsSaidWhy) {
    const CadModel all = read("all", 8, "/nowhere/ripstop-cad");
    EXPECT_THAT(all.surfaces, IsEmpty());
    EXPECT_EQ(all.unread.size(), 4U);
    EXPECT_THAT(all.remarks, Contains(HasSubstr("cannot be started")));
}

TEST_F(RhinoNurbs, BlocksStandInTheirPlacesAndMirroredOnesKeepTheirOutside) {
    const CadModel model = read("block", 8);
    ASSERT_EQ(model.surfaces.size(), 2U);
    for (const NamedMesh& surface : model.surfaces) {
        const double side = surface.name == "left" ? -500 : 500;
        EXPECT_NEAR(centroid(surface.mesh).x(), side, 1e-6) << surface.name;
        EXPECT_GT(area_vector(surface.mesh).z(), 0) << surface.name;
    }
}

TEST_F(RhinoNurbs, RealFilesGiveTheirSurfaces) {
    RIPSTOP_TOO_LONG_SANITIZED();
    RIPSTOP_REQUIRE_SHARED(folder, "rhino");
    const CadModel box = read_model(folder / "object_UserStrings.3dm", {.mesher = RIPSTOP_CAD_PROGRAM});
    ASSERT_EQ(box.surfaces.size(), 6U);
    EXPECT_EQ(box.surfaces[0].attributes.at("firstKey"), "123456");
    EXPECT_THAT(box.unread, IsEmpty());
    EXPECT_EQ(read_model(folder / "nurbsSurface_r5.3dm", {.mesher = RIPSTOP_CAD_PROGRAM}).surfaces.size(), 1U);
    const CadModel subd = read_model(folder / "input.3dm", {.mesher = RIPSTOP_CAD_PROGRAM});
    EXPECT_FALSE(subd.surfaces.empty());
    EXPECT_THAT(subd.remarks, Contains(HasSubstr("SubD")));
}

}  // namespace rhino_nurbs_test
}  // namespace ripstop

#endif
