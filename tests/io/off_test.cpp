#include "ripstop/io/mesh/off.h"

#include <gmock/gmock.h>

#include "support/mesh_text.h"
#include "support/outside.h"
#include "support/shapes.h"

namespace ripstop {
namespace off_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

CadModel model_of(const std::string& bytes) {
    return testing::read_bytes_with(read_off, bytes, "folder/hull.off");
}

std::string refusal(const std::string& bytes) {
    return testing::refusal_of(read_off, bytes, "folder/hull.off");
}

const std::string square = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

TEST(OffText, MayHaveItsCountsAnywhereAndComments) {
    for (const char* head :
         {"OFF\n4 1 0\n", "OFF 4 1 0\n", "4 1\n", "# c\n\nOFF # c\n#\n4 1 0 # c\n\n", "OFF\r\n4 1 0\r\n"})
        EXPECT_THAT(testing::corners_of(model_of(head + square + "4 0 1 2 3 255 0 0 # red\n").surfaces.at(0)),
                    ElementsAre(0, 1, 2, 0, 2, 3))
            << head;
}

TEST(OffText, MayHaveColoursNormalsAndTextures) {
    EXPECT_FALSE(model_of("COFF\n3 1 0\n0 0 0 1 1 1 1\n1 0 0 1 1 1 1\n0 1 0 1 1 1 1\n3 0 1 2\n").surfaces.at(0).drawn);
    EXPECT_FALSE(model_of("NOFF\n3 1 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n3 0 1 2\n").surfaces.at(0).drawn);
    for (const char* more : {" ", " 0 0 1 ", " 9 9 9 9 "}) {
        const std::string m = more;
        const auto surface =
            model_of("STOFF\n3 1 0\n0 0 0" + m + "0 0\n1 0 0" + m + "2 0\n0 1 0" + m + "0 3\n3 0 1 2\n").surfaces.at(0);
        ASSERT_TRUE(surface.drawn);
        EXPECT_EQ(surface.drawn->row(2), Eigen::RowVector2d(0, 3));
    }
}

TEST(OffSurfaces, AreTheConnectedParts) {
    EXPECT_THAT(
        testing::names_of(model_of("OFF 6 2 0\n0 0 0\n1 0 0\n0 1 0\n5 0 0\n6 0 0\n5 1 0\n3 3 4 5\n3 0 1 2\n").surfaces),
        ElementsAre("hull_01", "hull_02"));
}

std::string binary(const std::string& keyword, std::size_t more_floats) {
    using testing::bytes_of;
    std::string bytes = keyword + " BINARY\n" + bytes_of<std::uint32_t>({4, 2, 5}, true);
    for (const auto& [x, y] : {std::pair{0.F, 0.F}, std::pair{1.F, 0.F}, std::pair{1.F, 1.F}, std::pair{0.F, 1.5F}}) {
        bytes += bytes_of<float>({x, y, 0}, true);
        for (std::size_t i = 0; i < more_floats; ++i) bytes += bytes_of<float>({0.25F + x + y}, true);
    }
    return bytes + bytes_of<std::uint32_t>({3, 0, 1, 2, 0}, true) + bytes_of<std::uint32_t>({3, 0, 2, 3, 3}, true) +
           bytes_of<float>({1, 0, 0}, true);
}

TEST(OffBinary, IsReadWhateverStandsBehindXYZ) {
    for (const auto& [keyword, floats] :
         {std::pair{"OFF", 0U}, std::pair{"COFF", 4U}, std::pair{"NOFF", 3U}, std::pair{"STCNOFF", 9U}}) {
        const auto surface = model_of(binary(keyword, floats)).surfaces.at(0);
        EXPECT_THAT(testing::corners_of(surface), ElementsAre(0, 1, 2, 0, 2, 3)) << keyword;
        EXPECT_EQ(surface.mesh.positions(3, 1), 1.5);
        EXPECT_EQ(surface.drawn.has_value(), floats == 9);
    }
}

TEST(OffBinary, CutShortAnywhereIsRefused) {
    const std::string bytes = binary("OFF", 0);
    for (std::size_t length = 0; length < bytes.size(); ++length)
        EXPECT_NE(refusal(bytes.substr(0, length)), "accepted") << length;
    EXPECT_THAT(refusal(bytes.substr(0, 30)),
                HasSubstr("hull.off: byte 27: the file ends before all the vertices and faces"));
}

TEST(OffRefusal, NamesPlaceFaultAndRemedy) {
    const std::string four = "OFF\n4 1 0\n" + square;
    EXPECT_THAT(refusal(""), HasSubstr(":1: the file ends here, expected the counts"));
    EXPECT_THAT(refusal("solid\n"), HasSubstr(":1: found \"solid\", expected OFF and the number of vertices"));
    EXPECT_THAT(refusal("4OFF\n4 1 0\n"), HasSubstr(":1: points in more than three dimensions"));
    EXPECT_THAT(refusal("nOFF 2\n4 1 0\n"), HasSubstr(":1: points in more than three dimensions"));
    EXPECT_THAT(refusal("OFF\n4 -1 0\n"), HasSubstr(":2: found \"-1\", expected OFF and the number of faces"));
    EXPECT_THAT(refusal("OFF\n353535235358 9 0\n0 0 0\n"),
                HasSubstr(":3: the file ends here, expected 353535235358 vertices"));
    EXPECT_THAT(refusal("OFF\n4 1 0\n0 0\n"), HasSubstr(":3: a coordinate is missing"));
    EXPECT_THAT(refusal("OFF\n4 1 0\n0 0 nan\n"), HasSubstr(":3: found \"nan\""));
    EXPECT_THAT(refusal("STOFF\n4 1 0\n0 0 0 1\n"),
                HasSubstr(":3: found \"0 0 0 1\", expected a vertex with two texture"));
    EXPECT_THAT(refusal(four), HasSubstr(":6: the file ends here, expected 1 faces"));
    EXPECT_THAT(refusal(four + "3 0 1\n"), HasSubstr(":7: a corner is missing"));
    EXPECT_THAT(refusal(four + "3 0 1 4\n"), HasSubstr(":7: a face refers to vertex 4, expected one of the 4"));
    EXPECT_THAT(refusal(four + "3 0 1 -1\n"), HasSubstr(":7: a face refers to vertex -1"));
    EXPECT_THAT(refusal(four + "2 0 1\n"),
                HasSubstr("1 face with fewer than three different corners left out, the first in line 7"));
    EXPECT_THAT(refusal(four + "99 0 1\n"), HasSubstr(":7: found \"99\", expected the number of a face's corners"));
}

TEST(OffWriter, IsReadAlikeByAnIndependentReader) {
    if (testing::run_command("assimp version").code != 0) GTEST_SKIP() << "no assimp here";
    const testing::ScratchDirectory scratch;
    std::ostringstream out;
    write_off(out, {{"a", testing::octant(3), std::nullopt}, {"b", testing::saddle(1, 2, 3), std::nullopt}});
    testing::write_text(scratch.path("a.off"), out.str());
    const auto info = testing::run_command("assimp info " + scratch.path("a.off") + " -r");
    EXPECT_EQ(info.code, 0) << info.output;
    EXPECT_THAT(info.output, ::testing::ContainsRegex("Faces: +" + std::to_string(9 + 18))) << info.output;
}

}  // namespace off_test
}  // namespace ripstop
