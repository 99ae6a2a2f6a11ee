#include "ripstop/io/cad/converted.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "ripstop/base/error.h"
#include "support/shapes.h"

namespace ripstop {
namespace converted_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

ConvertedFace face(const std::string& name = "", double x = 0) {
    ConvertedFace result{.name = name, .mesh = testing::rectangle(1, 1, 2, 2)};
    result.mesh.positions.col(0).array() += x;
    return result;
}

std::string written(const ConvertedModel& model) {
    std::ostringstream out;
    write_converted(out, model);
    return out.str();
}

ConvertedModel read(const std::string& bytes) {
    std::istringstream in(bytes);
    return read_converted(in, "a.converted");
}

std::vector<std::string> names(const CadModel& model) {
    std::vector<std::string> result;
    for (const NamedMesh& surface : model.surfaces) result.push_back(surface.name);
    return result;
}

TEST(Converted, ReadsBackTheSameBitsAndWords) {
    ConvertedModel model;
    model.objects = {{"G 01", "Shell", {{"layer", "skin"}}, {face("a"), face("b", 1 / 3.0)}},
                     {"empty", "Brep", {}, {}}};
    model.objects[0].faces[0].area = 0.1;
    model.curves = {{"GRAIN", (Points3(2, 3) << 0, 0, 0, 0, 0, 1).finished(), {{"layer", "WARP"}}}};
    model.unread = {{"p", "Point", "points are not a surface", {}}};
    model.unit = LengthUnit{"in", 0.0254};
    model.layers = {"skin", "WARP"};
    model.remarks = {"one \"remark\"\nof two lines"};
    const ConvertedModel back = read(written(model));
    EXPECT_EQ(written(back), written(model));
    EXPECT_EQ(back.objects.at(0).faces.at(1).mesh.positions, model.objects[0].faces[1].mesh.positions);
    EXPECT_EQ(back.objects[0].faces[0].area, 0.1);
    EXPECT_EQ(back.unit->metres, 0.0254);
    EXPECT_EQ(back.remarks, model.remarks);
}

TEST(Converted, RefusesEveryTruncation) {
    ConvertedModel model;
    model.objects = {{"G01", "Shell", {}, {face()}}};
    const std::string whole = written(model);
    for (std::size_t size = 0; size < whole.size(); size += 7)
        EXPECT_THROW(read(whole.substr(0, size)), InputError) << size;
    EXPECT_THROW(read(whole + "x"), InputError);
}

TEST(Converted, NamesFacesAfterTheirObjectAndNoneTwice) {
    ConvertedModel model;
    model.objects = {{"G01", "Shell", {}, {face()}},
                     {"G01", "Shell", {}, {face()}},
                     {"G02", "Shell", {}, {face("top"), face(), face("top")}},
                     {"", "Face", {{"layer", "envelope::crown"}}, {face()}},
                     {"", "Face", {{"layer", "rest"}}, {face()}},
                     {"", "Face", {{"layer", "rest"}}, {face()}}};
    EXPECT_THAT(names(as_surfaces(model, TilesAs::faces, "balloon", {"crown"})),
                ElementsAre("G01", "G01_2", "G02/top", "G02_02", "G02/top_2", "crown_2", "balloon_01", "balloon_02"));
}

TEST(Converted, WeldsTheFacesOfAnObjectWhereTheyMeet) {
    ConvertedModel model;
    model.objects = {{"G01", "Shell", {}, {face("", 0), face("", 1)}}};
    const CadModel surfaces = as_surfaces(model, TilesAs::objects, "balloon");
    ASSERT_THAT(names(surfaces), ElementsAre("G01"));
    EXPECT_EQ(surfaces.surfaces[0].mesh.vertex_count(), 15);  // two 3 x 3 grids with three vertices in common
    EXPECT_NEAR(surface_area(surfaces.surfaces[0].mesh), 2, 1e-12);
}

TEST(Converted, SaysWhichMeshMissesItsArea) {
    ConvertedModel model;
    model.objects = {{"G01", "Shell", {}, {face()}}};
    model.objects[0].faces[0].area = 1.05;
    EXPECT_THAT(as_surfaces(model, TilesAs::faces, "").remarks,
                ElementsAre(HasSubstr("G01: its mesh has -4.8 % more area")));
}

}  // namespace converted_test
}  // namespace ripstop
