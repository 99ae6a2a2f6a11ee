#include "ripstop/io/mesh/stl.h"

#include <gmock/gmock.h>

#include <array>

#include "support/mesh_text.h"
#include "support/outside.h"
#include "support/shapes.h"

namespace ripstop {
namespace stl_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

CadModel model_of(const std::string& bytes) {
    return testing::read_bytes_with(read_stl, bytes, "folder/hull.stl");
}

std::string refusal(const std::string& bytes) {
    return testing::refusal_of(read_stl, bytes, "folder/hull.stl");
}

std::string facet(const char* a, const char* b, const char* c) {
    std::string text = "facet normal 0 0 1\nouter loop\n";
    for (const char* corner : {a, b, c}) text += std::string("vertex ") + corner + "\n";
    return text + "endloop\nendfacet\n";
}

const std::string lower_half = facet("0 0 0", "1 0 0", "0 1 0");
const std::string upper_half = facet("1 0 0", "1 1 0", "-0 1 0.0");
const std::string apart = facet("5 0 0", "6 0 0", "5 1 0");

std::string binary(const std::string& head, const std::vector<std::array<float, 9>>& triangles) {
    std::string bytes = head + std::string(80 - head.size(), ' ') +
                        testing::bytes_of<std::uint32_t>({static_cast<std::uint32_t>(triangles.size())});
    for (const auto& t : triangles)
        bytes += testing::bytes_of<float>({0, 0, 1, t[0], t[1], t[2], t[3], t[4], t[5], t[6], t[7], t[8]}) + "\x01\x02";
    return bytes;
}

const std::array<float, 9> half = {0, 0, 0, 1, 0, 0, 0, 1, 0};
const std::array<float, 9> other_half = {1, 0, 0, 1, 1, 0, 0, 1, 0};

TEST(StlSurfaces, AreTheSolids) {
    const auto surfaces = model_of("solid G01 P01\n" + lower_half + "endsolid G01 P01\n\nsolid G02\n" + upper_half +
                                   "end solid\nsolid empty\nendsolid\nsolid G01 P01\n" + upper_half + "endsolid\n")
                              .surfaces;
    EXPECT_THAT(testing::names_of(surfaces), ElementsAre("G01 P01", "G02"));
    EXPECT_THAT(testing::corners_of(surfaces[0]), ElementsAre(0, 1, 2, 1, 3, 2)) << "a name that comes back goes on";
    EXPECT_EQ(surfaces[1].mesh.vertex_count(), 3) << "welded within a solid alone";
}

TEST(StlSurfaces, AreTheConnectedPartsOfASolid) {
    EXPECT_THAT(testing::names_of(model_of("solid a\n" + lower_half + apart + upper_half + "endsolid\nsolid a_01\n" +
                                           apart + "endsolid\n")
                                      .surfaces),
                ElementsAre("a_02", "a_03", "a_01"))
        << "a name that is taken is passed over";
    EXPECT_THAT(
        testing::names_of(model_of("solid\n" + lower_half + "endsolid\nsolid \n" + apart + "endsolid").surfaces),
        ElementsAre("hull_01", "hull_02"));
    EXPECT_THAT(testing::names_of(model_of(binary("exported", {half, other_half})).surfaces), ElementsAre("hull"));
}

TEST(StlVertices, InOnePlaceAreOne) {
    const auto surface = model_of("solid\n" + lower_half + upper_half + "endsolid\n").surfaces.at(0);
    EXPECT_EQ(surface.mesh.vertex_count(), 4) << "0 and -0 are one place";
    EXPECT_THAT(testing::corners_of(surface), ElementsAre(0, 1, 2, 1, 3, 2));
    EXPECT_EQ(model_of("solid\n" + lower_half + facet("1 0 0", "1 1 0", "1e-300 1 0") + "endsolid\n")
                  .surfaces.at(0)
                  .mesh.vertex_count(),
              5)
        << "nearly one place is another";
}

TEST(StlTriangles, WithTwoCornersInOnePlaceAreLeftOutWithARemark) {
    const CadModel model = model_of("solid\n" + lower_half + facet("0 0 0", "1 0 0", "1 0 -0") + "endsolid\n");
    EXPECT_EQ(model.surfaces.at(0).mesh.triangle_count(), 1);
    EXPECT_THAT(model.remarks, ElementsAre("folder/hull.stl: 1 triangle left out: two corners in one place"));
    EXPECT_THAT(model_of("solid\n" + lower_half + "endsolid\n").remarks, IsEmpty());
}

TEST(StlText, MayBeInCapitalsAndEndItsLinesInAnyWay) {
    for (const char* end : {"\n", "\r\n", "\r", " \n\t"}) {
        std::string text;
        for (char c :
             "SOLID x\nFACET NORMAL 0 0 1\nOUTER LOOP\nVERTEX 0 0 0\nVERTEX +1.E0 0 0\nVertex 0 1 0\nENDLOOP\n"
             "EndFacet\nENDSOLID x\n")
            if (c == '\n') {
                text += end;
            } else if (c != '\0') {
                text += c;
            }
        EXPECT_EQ(model_of(text).surfaces.at(0).mesh.positions(1, 0), 1);
    }
}

TEST(StlBinary, IsToldByItsLengthWhateverItsHeaderSays) {
    for (const char* head : {"", "solid of another program", "SOLID"}) {
        const auto surface = model_of(binary(head, {half, other_half})).surfaces.at(0);
        EXPECT_THAT(testing::corners_of(surface), ElementsAre(0, 1, 2, 1, 3, 2));
    }
    EXPECT_EQ(model_of(binary("more behind it", {half}) + "tail").surfaces.at(0).mesh.triangle_count(), 1);
}

TEST(StlBinary, CutShortAnywhereIsRefused) {
    for (const char* head : {"x", "solid"}) {
        const std::string bytes = binary(head, {half, other_half});
        for (std::size_t length = 0; length < bytes.size(); ++length)
            EXPECT_NE(refusal(bytes.substr(0, length)), "accepted") << head << length;
    }
    EXPECT_THAT(refusal(binary("x", {half, other_half}).substr(0, 150)),
                HasSubstr("hull.stl: byte 80: the file says it has 2 triangles, but there are bytes for 1"));
}

TEST(StlRefusal, NamesPlaceFaultAndRemedy) {
    EXPECT_THAT(refusal(""), HasSubstr("hull.stl: no face"));
    EXPECT_THAT(refusal("o tile\n"), HasSubstr(":1: found \"o\", expected solid"));
    EXPECT_THAT(refusal("solid a\n" + lower_half), HasSubstr(":8: the file ends here, expected endsolid"));
    EXPECT_THAT(refusal("solid a\nvertex 0 0 0\n"), HasSubstr(":2: found \"vertex\", expected facet or endsolid"));
    EXPECT_THAT(refusal("solid\nfacet\nouter loop\nvertex 0 0\n"), HasSubstr(":4: a coordinate is missing"));
    EXPECT_THAT(refusal("solid\nfacet\nouter loop\nvertex 0 0 inf\n"), HasSubstr(":4: found \"inf\""));
    EXPECT_THAT(refusal("solid\nfacet\nouter loop\nvertex 0 0 0\nendloop\n"), HasSubstr(":5: a facet with 1 vertex"));
    std::array<float, 9> far = half;
    far[4] = 1e13F;
    EXPECT_THAT(refusal(binary("x", {half, far})),
                HasSubstr("hull.stl: byte 162: the coordinate 9999999827968 is too large"));
}

TEST(StlWriter, IsReadAlikeByAnIndependentReader) {
    if (testing::run_command("assimp version").code != 0) GTEST_SKIP() << "no assimp here";
    const testing::ScratchDirectory scratch;
    std::ostringstream out;
    write_stl(out, {{"G01", testing::octant(3), std::nullopt}, {"G02", testing::saddle(1, 2, 3), std::nullopt}});
    testing::write_text(scratch.path("a.stl"), out.str());
    const auto info = testing::run_command("assimp info " + scratch.path("a.stl") + " -r");
    EXPECT_EQ(info.code, 0) << info.output;
    EXPECT_THAT(info.output, ::testing::ContainsRegex("Meshes: +2"));
    EXPECT_THAT(info.output, ::testing::ContainsRegex("Faces: +" + std::to_string(9 + 18))) << info.output;
    EXPECT_THAT(info.output, ::testing::AllOf(HasSubstr("G01"), HasSubstr("G02")));
}

}  // namespace stl_test
}  // namespace ripstop
