#include "ripstop/io/mesh/obj.h"

#include <gmock/gmock.h>

#include <sstream>

#include "ripstop/base/error.h"
#include "support/mesh_text.h"
#include "support/refusal.h"

namespace ripstop {
namespace obj_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

std::vector<NamedMesh> read(const std::string& text, double metres_per_unit = 1) {
    std::istringstream in(text);
    return in_metres(read_obj(in, "folder/hull.obj"), metres_per_unit).surfaces;
}

CadModel model_of(const std::string& text) {
    std::istringstream in(text);
    return read_obj(in, "folder/hull.obj");
}

std::string refusal(const std::string& text) {
    return testing::refusal([&] { read(text); });
}

std::vector<std::string> names(const std::vector<NamedMesh>& surfaces) {
    std::vector<std::string> result;
    for (const NamedMesh& surface : surfaces) result.push_back(surface.name);
    return result;
}

std::vector<int> corners(const NamedMesh& surface) {
    return {surface.mesh.triangles.data(), surface.mesh.triangles.data() + surface.mesh.triangles.size()};
}

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(ObjSurfaces, AreTheObjectsInTheirOrder) {
    const auto surfaces = read(square + "o G02\nf 1 2 3\no G01\nf 1 3 4\no empty\n");
    EXPECT_THAT(names(surfaces), ElementsAre("G02", "G01"));
    EXPECT_EQ(surfaces[1].mesh.vertex_count(), 3);
    EXPECT_EQ(surfaces[1].mesh.positions.row(1), Eigen::RowVector3d(1, 1, 0));
}

TEST(ObjSurfaces, AreTheGroupsWhereThereAreNoObjects) {
    EXPECT_THAT(names(read(square + "g left  side \nf 1 2 3\ng\tright\nf 1 3 4\n")),
                ElementsAre("left  side", "right"));
}

TEST(ObjSurfaces, AreNamedAfterObjectAndGroupWhereBothAreGiven) {
    const auto surfaces = read(square + "o hull\nf 1 2 3\ng left\nf 1 3 4\ng hull\nf 2 3 4\no skirt\nf 1 2 4\n");
    EXPECT_THAT(names(surfaces), ElementsAre("hull", "hull/left", "skirt"));
    EXPECT_EQ(surfaces[0].mesh.triangle_count(), 2);
}

TEST(ObjSurfaces, GoOnWhereTheirNameComesBack) {
    const auto surfaces = read(square + "g a\nf 1 2 3\ng b\nf 2 3 4\ng a\nf 1 3 4\n");
    EXPECT_THAT(names(surfaces), ElementsAre("a", "b"));
    EXPECT_THAT(corners(surfaces[0]), ElementsAre(0, 1, 2, 0, 2, 3));
}

TEST(ObjSurfaces, AreTheConnectedPartsWhereNothingHasAName) {
    const auto two = read(square + "v 5 0 0\nv 6 0 0\nv 5 1 0\nf 5 6 7\nf 1 2 3\n");
    EXPECT_THAT(names(two), ElementsAre("hull_01", "hull_02"));
    EXPECT_EQ(two[0].mesh.positions(0, 0), 5);
    EXPECT_THAT(names(read(square + "f 1 2 3 4\n")), ElementsAre("hull"));
}

TEST(ObjSurfaces, AreNumberedSoThatTheirNamesSort) {
    std::string text;
    for (int i = 0; i < 100; ++i) text += "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\n";
    const auto surfaces = read(text);
    ASSERT_EQ(surfaces.size(), 100U);
    EXPECT_EQ(surfaces.front().name, "hull_001");
    EXPECT_EQ(surfaces.back().name, "hull_100");
}

TEST(ObjSurfaces, CollectNamelessFacesBeforeTheFirstNameUnderTheFilesName) {
    EXPECT_THAT(names(read(square + "f 1 2 3\no G01\nf 1 3 4\n")), ElementsAre("hull", "G01"));
}

TEST(ObjSurfaces, HaveReadableNames) {
    EXPECT_THAT(names(read(square + "o H\xFClle\nf 1 2 3\no H\xC3\xBClle 2\nf 1 2 3\no a\x01 b\nf 1 2 3\n")),
                ElementsAre("H\xC3\xBClle", "H\xC3\xBClle 2", "a_ b"));
}

TEST(ObjVertices, AreNeverWelded) {
    const auto surfaces = read("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 0\nv -1 0 0\no dart\nf 1 2 3\nf 4 3 5\n");
    EXPECT_EQ(surfaces[0].mesh.vertex_count(), 5);
}

TEST(ObjVertices, KeepTheFilesOrderAndOnlyTheUsedOnesStay) {
    const auto surfaces = read("v 9 9 9\nv 0 0 0\nv 1 0 0\nv 8 8 8\nv 0 1 0\nf 5 2 3\n");
    Points3 expected(3, 3);
    expected << 0, 0, 0, 1, 0, 0, 0, 1, 0;
    EXPECT_EQ(surfaces[0].mesh.positions, expected);
    EXPECT_THAT(corners(surfaces[0]), ElementsAre(2, 0, 1));
}

TEST(ObjVertices, AreScaledToMetresWithWhatIsDrawn) {
    const auto surfaces = read("v 0 0 0\nv 1000 0 0\nv 0 500 0\nvt 1 2\nvt 3 4\nvt 5 6\nf 1/1 2/2 3/3\n", 0.001);
    EXPECT_DOUBLE_EQ(surfaces[0].mesh.positions(1, 0), 1);
    ASSERT_TRUE(surfaces[0].drawn);
    EXPECT_DOUBLE_EQ((*surfaces[0].drawn)(2, 1), 0.006);
}

TEST(ObjVertices, MayHaveAWeightOrAColourAndAComment) {
    EXPECT_EQ(read("v 0 0 0 1\nv 1 0 0 .5 .5 .5\nv 0 1 0 1 1 1 1 # last\nf 1 2 3 # one\n")[0].mesh.positions(2, 1), 1);
}

TEST(ObjVertices, MayStandInAnyUsualNumberFormat) {
    const auto surfaces = read("v +1. -.5 1E+2\nv 1e-003 0 0\nv\t0  1\t0\nf 1 2 3\n");
    EXPECT_EQ(surfaces[0].mesh.positions.row(0), Eigen::RowVector3d(1, -0.5, 100));
    EXPECT_EQ(surfaces[0].mesh.positions(1, 0), 0.001);
}

TEST(ObjFaces, AreFannedFromTheirFirstCornerWhereConvex) {
    EXPECT_THAT(corners(read(square + "v -1 .5 0\nf 2 3 4 5 1\n")[0]), ElementsAre(1, 2, 3, 1, 3, 4, 1, 4, 0));
}

TEST(ObjFaces, AreFannedFromTheNotchWhereThatIsTheOnlyWay) {
    const auto surfaces = read("v 0 1 0\nv 1 0 0\nv 0 -1 0\nv 2 0 0\nf 1 2 3 4\n");
    EXPECT_THAT(corners(surfaces[0]), ElementsAre(1, 2, 3, 1, 3, 0));
    EXPECT_DOUBLE_EQ(surface_area(surfaces[0].mesh), 1) << "the arrowhead's own area: no triangle lies outside";
}

TEST(ObjFaces, MayCountFromTheEndOrNameVerticesThatFollow) {
    EXPECT_THAT(corners(read("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 9 9 9\n")[0]), ElementsAre(0, 1, 2));
    EXPECT_THAT(corners(read("f 1 2 3\n" + square)[0]), ElementsAre(0, 1, 2));
}

TEST(ObjFaces, MayCarryTextureAndNormalIndices) {
    for (const char* face : {"f 1 2 3", "f 1//1 2//1 3//1", "f 1/1/1 2/2/1 3/3/1", "f 1/ 2/ 3/", "f 1/1/ 2/2/ 3/3/"})
        EXPECT_THAT(corners(read(square + "vt 0 0\nvt 1 0\nvt 1 1\nvn 0 0 1\n" + face)[0]), ElementsAre(0, 1, 2))
            << face;
}

TEST(ObjDrawn, IsFilledOnlyWhereEachVertexHasOnePlace) {
    const std::string flat = square + "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 1 1\nvt 7 7\n";
    EXPECT_TRUE(read(flat + "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n")[0].drawn);
    EXPECT_TRUE(read(flat + "f 1/1 2/2 3/3\nf 1/1 3/5 4/4\n")[0].drawn) << "the same place under another number";
    EXPECT_FALSE(read(flat + "f 1/1 2/2 3/3\nf 1/1 3/6 4/4\n")[0].drawn) << "two places for one vertex";
    EXPECT_FALSE(read(flat + "f 1/1 2/2 3/3\nf 1 3 4\n")[0].drawn) << "a corner without";
    EXPECT_TRUE(read(square + "vt 0\nvt 1\nvt 2 # a\nf 1/1 2/2 3/3\n")[0].drawn) << "v is 0 where absent";
}

TEST(ObjCurves, AreThePolylinesUnderTheirObjectAndGroup) {
    const CadModel model = model_of(square + "f 1 2 3\no GRAIN\nl 1/4 2 -2\no hull\ng WARP\nl 4 1\nl 3 2\n");
    ASSERT_EQ(model.curves.size(), 3U);
    EXPECT_EQ(model.curves[0].name, "GRAIN");
    EXPECT_EQ(model.curves[0].attributes.at("layer"), "GRAIN");
    EXPECT_EQ(model.curves[1].name, "hull/WARP");
    EXPECT_EQ(model.curves[1].attributes.at("layer"), "hull::WARP");
    EXPECT_EQ(model.curves[1].points.row(0), Eigen::RowVector3d(0, 1, 0));
    EXPECT_THAT(names(model.surfaces), ElementsAre("hull")) << "a name without faces is none";
}

TEST(ObjCurves, GoOnWhereTheNextStartsAtTheirEnd) {
    const CadModel model = model_of(square + "f 1 2 3\nl 1 2\nl 2 3\nl 4 1\ng a\nl 1 2\n");
    ASSERT_EQ(model.curves.size(), 3U);
    EXPECT_EQ(model.curves[0].points.rows(), 3);
    EXPECT_EQ(model.curves[0].name, "hull");
    EXPECT_TRUE(model.curves[0].attributes.empty());
}

TEST(ObjCurves, WithOnePointAreLeftOutWithARemark) {
    const CadModel model = model_of(square + "f 1 2 3\nl 1\n");
    EXPECT_TRUE(model.curves.empty());
    EXPECT_THAT(model.remarks,
                ElementsAre("the polyline in line 6 of folder/hull.obj left out: it has fewer than two points"));
}

TEST(ObjUnread, AreSurfacesAndCurvesByEquations) {
    const CadModel model = model_of(square + "o tile\nf 1 2 3\no nurbs\nsurf 0 1 0 1 1 2 3 4\ncurv 0 1 1 2\n");
    ASSERT_EQ(model.unread.size(), 2U);
    EXPECT_EQ(model.unread[0].name, "nurbs");
    EXPECT_EQ(model.unread[0].type, "Surface");
    EXPECT_THAT(model.unread[0].reason,
                HasSubstr("(surf in line 8), which are not read from OBJ; export it as a mesh"));
    EXPECT_THAT(refusal(square + "surf 0 1 0 1 1 2 3 4\n"),
                HasSubstr("(surf, curv) are not read; export the surfaces"));
}

TEST(ObjMaterial, IsKeptWhereAllFacesOfASurfaceHaveOne) {
    const auto surfaces =
        read(square + "usemtl red  cloth\no a\nf 1 2 3\nf 1 3 4\no b\nf 1 2 4\nusemtl blue\nf 2 3 4\no c\nf 1 2 3\n");
    EXPECT_EQ(surfaces[0].attributes.at("material"), "red  cloth");
    EXPECT_EQ(surfaces[1].attributes.count("material"), 0U);
    EXPECT_EQ(surfaces[2].attributes.at("material"), "blue");
}

TEST(ObjLines, MayBeContinued) {
    EXPECT_THAT(corners(read(square + "f 1 \\\n 2 \\\n3\n")[0]), ElementsAre(0, 1, 2));
    EXPECT_THAT(refusal(square + "f 1 \\\n 2 \\\n3\nf 1 \\\n9 3"), StartsWith("folder/hull.obj:8:"));
    EXPECT_THAT(corners(read("# C:\\folder\\\n" + square + "mtllib a\\\nf 1 2 3\\")[0]), ElementsAre(0, 1, 2));
}

TEST(ObjLines, MayEndInAnyWayAndStartWithBlanks) {
    for (const char* end : {"\n", "\r\n", "\r", " \t\r\n"}) {
        std::string text;
        for (const char* line : {"v 0 0 0", " \tv 1 0 0", "v 0 1 0", "", "o tile", "f 1 2 3"})
            text += std::string(line) + end;
        EXPECT_THAT(names(read(text)), ElementsAre("tile"));
        text.erase(text.size() - std::string(end).size());
        EXPECT_THAT(names(read("\xEF\xBB\xBF" + text)), ElementsAre("tile"));
    }
}

TEST(ObjRefusal, NamesFileLineFaultAndRemedy) {
    EXPECT_THAT(refusal("v 0 0 0\nv 1,5 0 0\n"),
                StartsWith("folder/hull.obj:2: found \"1,5\", expected a finite number"));
    EXPECT_THAT(refusal("v nan 0 0\n"), HasSubstr(":1: found \"nan\""));
    EXPECT_THAT(refusal("v 0 -inf 0\n"), HasSubstr(":1: found \"-inf\""));
    EXPECT_THAT(refusal("v 1e400 0 0\n"), HasSubstr(":1: found \"1e400\""));
    EXPECT_THAT(refusal("v 1e13 0 0\n"), HasSubstr(":1: the coordinate \"1e13\" is too large"));
    EXPECT_THAT(refusal("\n\nv 0 0\n"), HasSubstr(":3: a coordinate is missing"));
    EXPECT_THAT(refusal(square + "f 1 2 5\n"), HasSubstr(":5: a face refers to vertex 5, expected one of the 4"));
    EXPECT_THAT(refusal(square + "f 1 2 -5\n"), HasSubstr(":5: a face refers to vertex -5, expected one of the 4"));
    EXPECT_THAT(refusal(square + "f 0 1 2\n"), HasSubstr(":5: a face refers to vertex 0, expected one of the 4"));
    EXPECT_THAT(refusal(square + "f 1/1 2/1 3/1\n"),
                HasSubstr(":5: a face refers to texture coordinate 1, expected one of the 0"));
    EXPECT_THAT(refusal(square + "f 1 2 x\n"), HasSubstr(":5: found \"x\" as a corner of a face"));
    EXPECT_THAT(refusal(square + "f 1 2 3.5\n"), HasSubstr(":5: found \"3.5\" as a corner"));
    EXPECT_THAT(refusal(square + "f 1 2 99999999999999999999\n"), HasSubstr(":5: found \"99999999999999999999\""));
    EXPECT_THAT(refusal(square + "f 1 2 5000000000\n"), HasSubstr(":5: a face refers to vertex 5000000000"));
    EXPECT_THAT(refusal(square + "f 1/1/1/1 2 3\n"),
                HasSubstr(":5: found \"1/1/1/1\" as a corner of a face, expected at most three"));
    for (const char* face : {"f 1 2", "f 1", "f 1 1 1 1", "f 1 2 1", "f 1 2 3 2", "f 1 2 3 3 2", "f 2 1 2 3"})
        EXPECT_THAT(
            refusal(square + face + "\n"),
            HasSubstr("hull.obj: no face (1 face with fewer than three different corners left out, the first in "
                      "line 5)"))
            << face;
    EXPECT_THAT(refusal(square + "f 1 2 3\nl 1 5\n"),
                HasSubstr(":6: a polyline names vertex 5, expected one of the 4"));
    EXPECT_THAT(refusal(square + "f 1 2 3\nl 1 x\n"), HasSubstr(":6: found \"x\" as a corner of a polyline"));
}

TEST(ObjFaces, ThatNameACornerAgainAreWhatIsLeftOfThem) {
    for (const char* face : {"f 1 2 3", "f 1 2 3 3", "f 1 2 2 3", "f 1 1 2 3", "f 1 2 3 1", "f 1 2 2 2 3 3 1 1",
                             "f 1 4 1 2 3", "f 1 2 3 4 3", "f 2 3 4 3 1 2"}) {
        const CadModel model = model_of(square + face + "\n");
        EXPECT_EQ(testing::corners_of(model.surfaces.at(0)).size(), 3u) << face;
        EXPECT_THAT(model.remarks, IsEmpty()) << face;
    }
    const CadModel model = model_of(square + "f 1 2 3\nf 1 1 2\nf 1 3 4 4\nf 2 2\n");
    EXPECT_EQ(model.surfaces.at(0).mesh.triangle_count(), 2);
    EXPECT_THAT(model.remarks, ElementsAre(HasSubstr("2 faces with fewer than three different corners left out, the "
                                                     "first in line 6")));
}

TEST(ObjObjects, WithoutAFaceAreNamed) {
    const CadModel model = model_of(square + "o empty\no G01\ng left\nf 1 2 3\no a\no line\nl 1 2\no b\ng c\n");
    EXPECT_THAT(model.remarks, ElementsAre(HasSubstr("3 objects without a face or line: empty, a, b")));
}

TEST(ObjFaces, WithTwoCornersInOnePlaceLeaveATriangleWithoutArea) {
    const CadModel model = model_of("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 1 1 0\nf 1 2 3 4\n");
    EXPECT_EQ(model.surfaces.at(0).mesh.triangle_count(), 2);
    EXPECT_EQ(model.surfaces.at(0).fault, "");
    EXPECT_NEAR(surface_area(model.surfaces.at(0).mesh), 0.5, 1e-15);
}

TEST(ObjFaces, ThatFoldAreTheFaultOfTheirSurfaceAlone) {
    const std::string two = "v 2 1 0\nv 2 2 0\no good\nf 1 2 3\no bad\n";
    for (const auto& [face, what] :
         {std::pair("f 1 3 2 4", "folder/hull.obj:10: a face with 4 corners folds over itself"),
          std::pair("f 1 2 3 1 5 6", "folder/hull.obj:10: a face with 6 corners uses one of them twice")}) {
        const CadModel model = model_of(square + two + face + "\n");
        ASSERT_EQ(model.surfaces.size(), 2u);
        EXPECT_EQ(model.surfaces[0].fault, "");
        EXPECT_THAT(model.surfaces[1].fault, StartsWith(what));
    }
}

TEST(ObjRefusal, SaysWhatAFileIsThatIsNoObj) {
    EXPECT_THAT(refusal(""), HasSubstr("folder/hull.obj: no face"));
    EXPECT_THAT(refusal(square), HasSubstr("no face (a line that starts with f) in 4 lines"));
    EXPECT_THAT(refusal(std::string("\xFF\xFEv\0 \0", 6)), HasSubstr("the text is UTF-16"));
    EXPECT_THAT(refusal(std::string("v 0 0 0\nv\0", 10)), HasSubstr(":2: a zero byte"));
}

TEST(ObjRefusal, QuotesNoMoreThanALineOfWhatItFound) {
    std::string text = "v ";
    text.append(100000, 'x');
    EXPECT_LT(refusal(text).size(), 200U);
}

}  // namespace obj_test
}  // namespace ripstop
