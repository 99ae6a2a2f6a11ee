#include "ripstop/io/mesh/ply.h"

#include <gmock/gmock.h>

#include "support/mesh_text.h"
#include "support/outside.h"
#include "support/shapes.h"

namespace ripstop {
namespace ply_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

CadModel model_of(const std::string& bytes) {
    return testing::read_bytes_with(read_ply, bytes, "folder/hull.ply");
}

std::string refusal(const std::string& bytes) {
    return testing::refusal_of(read_ply, bytes, "folder/hull.ply");
}

std::string ascii(const std::string& header, const std::string& body) {
    return "ply\nformat ascii 1.0\n" + header + "end_header\n" + body;
}

const std::string vertices = "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n";
const std::string square = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
const std::string list = "property list uchar int vertex_indices\n";

TEST(PlySurfaces, AreTheTilesOfTheirFaces) {
    const auto surfaces = model_of(ascii("comment tile 7 G01  P02\ncomment tile x y\n" + vertices + "element face 3\n" +
                                             list + "property short tile\nproperty int group\n",
                                         square + "3 0 1 2 7 1\n3 0 2 3 -2 1\n3 1 2 3 7 2\n"))
                              .surfaces;
    EXPECT_THAT(testing::names_of(surfaces), ElementsAre("G01  P02", "hull_-2"));
    EXPECT_THAT(testing::corners_of(surfaces[0]), ElementsAre(0, 1, 2, 1, 2, 3));
    EXPECT_EQ(surfaces[1].mesh.vertex_count(), 3);
}

TEST(PlySurfaces, MayBeNumberedUnderAnyUsualName) {
    for (const char* name : {"tile", "tile_id", "label", "group", "object"})
        EXPECT_THAT(testing::names_of(model_of(ascii(vertices + "element face 2\nproperty uint " + name + "\n" + list,
                                                     square + "1 3 0 1 2\n4000000000 3 0 2 3\n"))
                                          .surfaces),
                    ElementsAre("hull_1", "hull_4000000000"))
            << name;
}

TEST(PlySurfaces, AreTheConnectedPartsWhereNoFaceHasANumber) {
    const std::string six = "element vertex 6\nproperty double x\nproperty double y\nproperty double z\n";
    const std::string points = "0 0 0\n1 0 0\n0 1 0\n5 0 0\n6 0 0\n5 1 0\n";
    EXPECT_THAT(
        testing::names_of(model_of(ascii(six + "element face 2\n" + list, points + "3 3 4 5\n3 0 1 2\n")).surfaces),
        ElementsAre("hull_01", "hull_02"));
    EXPECT_THAT(testing::names_of(model_of(ascii(six + "element face 1\n" + list, points + "3 3 4 5\n")).surfaces),
                ElementsAre("hull"));
}

TEST(PlyFaces, AreFannedAndMayComeAsStrips) {
    EXPECT_THAT(testing::corners_of(
                    model_of(ascii(vertices + "element face 1\n" + list, square + "4 0 1 2 3\n")).surfaces.at(0)),
                ElementsAre(0, 1, 2, 0, 2, 3));
    // Every other triangle of a strip has the opposite orientation; one with a repeated vertex joins strips.
    const auto strip = model_of(ascii(vertices + "element tristrips 1\nproperty list int int vertex_indices\n",
                                      square + "10 0 1 3 2 -1 1 2 3 3 0\n"))
                           .surfaces.at(0);
    EXPECT_THAT(testing::corners_of(strip), ElementsAre(0, 1, 3, 3, 1, 2, 1, 2, 3));
}

TEST(PlyWarp, IsThatOfEachTriangleOfASurface) {
    for (const char* key : {"warp", "grain"}) {
        std::string header = vertices + "element face 2\n" + list + "property int tile\n";
        for (const char* axis : {"x", "y", "z"}) header += std::string("property float ") + key + "_" + axis + "\n";
        const auto surfaces = model_of(ascii(header, square + "4 0 1 2 3 1 0 0.5 -2\n3 0 1 3 2 0 0 0\n")).surfaces;
        Points3 expected(2, 3);
        expected << 0, 0.5, -2, 0, 0.5, -2;
        EXPECT_EQ(surfaces.at(0).warp, expected);
        EXPECT_EQ(surfaces.at(1).warp.rows(), 0);
        EXPECT_THAT(refusal(ascii(header, square + "3 0 1 2 1 0 0.5 -2\n3 0 2 3 1 0 0 0\n")),
                    HasSubstr(":19: a face of hull_1 has the warp 0 0 0 but others have a direction"));
    }
}

TEST(PlyDrawn, IsThePlaceOnTheClothUnderAnyUsualName) {
    for (const auto& [u, v] : {std::pair{"u", "v"}, std::pair{"s", "t"}, std::pair{"texture_u", "texture_v"}}) {
        const std::string header =
            vertices + "property float " + u + "\nproperty float " + v + "\nelement face 1\n" + list;
        const auto surface =
            model_of(ascii(header, "0 0 0 9 9\n0 0 1 8 8\n1 0 0 1 2\n0 1 0 3 4\n3 3 2 0\n")).surfaces.at(0);
        ASSERT_TRUE(surface.drawn);
        EXPECT_EQ(surface.drawn->row(1), Eigen::RowVector2d(1, 2));
    }
}

TEST(PlyUnit, IsThatOfTheComment) {
    const std::string rest = vertices + "element face 1\n" + list;
    EXPECT_EQ(model_of(ascii("comment unit mm\n" + rest, square + "3 0 1 2\n")).unit->metres, 0.001);
    EXPECT_FALSE(model_of(ascii(rest, square + "3 0 1 2\n")).unit);
    const CadModel model = model_of(ascii("comment unit cubits\n" + rest, square + "3 0 1 2\n"));
    EXPECT_FALSE(model.unit);
    EXPECT_THAT(model.remarks, ElementsAre(StartsWith("folder/hull.ply:3: the file's unit is ignored")));
}

/// Every type, and an element and a list without meaning here, in either byte order.
std::string binary(bool big) {
    using testing::bytes_of;
    std::string bytes = std::string("ply\r\nformat binary_") + (big ? "big" : "little") +
                        "_endian 1.0\r\nelement junk 2\r\nproperty double a\r\nproperty list ushort float b\r\n"
                        "element vertex 3\r\nproperty uchar red\r\nproperty short x\r\nproperty double y\r\n"
                        "property float z\r\nelement face 1\r\nproperty char tile\r\n"
                        "property list uint ushort vertex_index\r\nend_header\r\n";
    for (const std::uint16_t count : {std::uint16_t{0}, std::uint16_t{2}}) {
        bytes += bytes_of<double>({0.5}, big);
        bytes += bytes_of<std::uint16_t>({count}, big);
        for (int i = 0; i < count; ++i) bytes += bytes_of<float>({1}, big);
    }
    for (const std::int16_t x : {std::int16_t{0}, std::int16_t{-300}, std::int16_t{300}}) {
        bytes += '\n';  // red: any byte, such as a line end
        bytes += bytes_of<std::int16_t>({x}, big);
        bytes += bytes_of<double>({x / 7.0}, big);
        bytes += bytes_of<float>({x == 0 ? 0.5F : 0}, big);
    }
    bytes += '\xFE';
    bytes += bytes_of<std::uint32_t>({3}, big);
    bytes += bytes_of<std::uint16_t>({0, 2, 1}, big);
    return bytes;
}

TEST(PlyBinary, HoldsTheNumbersOfEitherOrderOfBytes) {
    for (const bool big : {false, true}) {
        const auto surface = model_of(binary(big)).surfaces.at(0);
        EXPECT_EQ(surface.name, "hull_-2");
        EXPECT_EQ(surface.mesh.positions.row(1), Eigen::RowVector3d(-300, -300 / 7.0, 0));
        EXPECT_THAT(testing::corners_of(surface), ElementsAre(0, 2, 1));
    }
}

TEST(PlyBinary, CutShortAnywhereIsRefusedByItsByte) {
    for (const bool big : {false, true}) {
        const std::string bytes = binary(big);
        for (std::size_t length = 0; length < bytes.size(); ++length)
            EXPECT_THAT(refusal(bytes.substr(0, length)), StartsWith("folder/hull.ply:")) << length;
        EXPECT_THAT(refusal(bytes.substr(0, bytes.size() - 1)), HasSubstr(": byte "));
    }
}

TEST(PlyText, CutShortAnywhereIsRefusedButForItsLastLineEnd) {
    const std::string bytes = ascii("comment tile 1 a\n" + vertices + "element face 2\nproperty int tile\n" + list,
                                    square + "1 3 0 1 2\n1 3 0 2 3\n");
    for (std::size_t length = 0; length + 1 < bytes.size(); ++length)
        EXPECT_THAT(refusal(bytes.substr(0, length)), StartsWith("folder/hull.ply:")) << length;
    EXPECT_EQ(refusal(bytes.substr(0, bytes.size() - 1)), "accepted");
}

TEST(PlyRefusal, NamesPlaceFaultAndRemedy) {
    const auto with_face = [](const std::string& face) {
        return refusal(ascii(vertices + "element face 1\n" + list, square + face));
    };
    EXPECT_THAT(with_face("3 0 1 4\n"), HasSubstr("hull.ply:14: a face refers to vertex 4, expected one of the 4"));
    EXPECT_THAT(with_face("3 0 1 -1\n"), HasSubstr(":14: a face refers to vertex -1"));
    EXPECT_THAT(
        with_face("3 0 1 1\n"),
        HasSubstr("hull.ply: no face (1 face with fewer than three different corners left out, the first in line 14)"));
    EXPECT_THAT(with_face("3 0 1 .5\n"), HasSubstr(":14: a corner of a face is not a whole number"));
    EXPECT_THAT(with_face("3 0 1\n"), HasSubstr(":14: the line is too short"));
    EXPECT_THAT(with_face("3 0 1 2 3\n"), HasSubstr(":14: found \"3\" after the last property"));
    EXPECT_THAT(with_face("99999 0 1 2\n"), HasSubstr(":14: a list of 99999 numbers, more than the line has"));
    EXPECT_THAT(with_face("2 0 1\n"), HasSubstr("hull.ply: no face (1 face with fewer than three"));
    EXPECT_THAT(with_face(""), HasSubstr(":13: the file ends here, expected 1 lines of \"face\""));
    EXPECT_THAT(with_face("3 0 1 2\n3 0 1 2\n"), HasSubstr(":15: found \"3 0 1 2\" after the last element"));
    EXPECT_THAT(refusal(ascii(vertices + "element face 1\n" + list, "nan 0 0\n")), HasSubstr(":10: found \"nan\""));
    EXPECT_THAT(refusal(ascii("element vertex 1\nproperty float x\n", "0\n")),
                HasSubstr("the vertices have no x, y and z"));
    EXPECT_THAT(refusal(ascii(vertices + "element face 1\nproperty int tile\n", square + "1\n")),
                HasSubstr("the faces have no list vertex_indices"));
    EXPECT_THAT(refusal(ascii(vertices, square)), HasSubstr("hull.ply: no face"));
}

TEST(PlyRefusal, NamesTheLineOfTheHeader) {
    EXPECT_THAT(refusal(""), HasSubstr(":1: found \"\", expected the line ply"));
    EXPECT_THAT(refusal("plywood\n"), HasSubstr(":1: found \"plywood"));
    EXPECT_THAT(refusal("ply\nformat ascii 1.0\n"), HasSubstr(":2: the header stops here, expected end_header"));
    EXPECT_THAT(refusal("ply\nformat ascii 2.0\n"), HasSubstr(":2: found the version \"2.0\""));
    EXPECT_THAT(refusal("ply\nformat text 1.0\n"), HasSubstr(":2: found the format \"text\""));
    EXPECT_THAT(refusal("ply\nend_header\n"), HasSubstr(":2: no format line"));
    EXPECT_THAT(refusal("ply\nelement face -1\n"), HasSubstr(":2: found the count \"-1\" of the element \"face\""));
    EXPECT_THAT(refusal("ply\nproperty int a\n"), HasSubstr(":2: a property before the first element"));
    EXPECT_THAT(refusal("ply\nelement a 1\nproperty half b\n"), HasSubstr(":3: found the type \"half\""));
    EXPECT_THAT(refusal("ply\nelement a 1\nproperty list float int b\n"), HasSubstr(":3: a list length of floating"));
    EXPECT_THAT(refusal("ply\nelement a 1\nproperty int\n"), HasSubstr(":3: a property without a name"));
    EXPECT_THAT(refusal("ply\nrubbish\n"), HasSubstr(":2: found \"rubbish\", expected format, comment"));
}

TEST(PlyRefusal, ComesBeforeAnyAllocationByTheCountsOfTheHeader) {
    const std::string most = "18446744073709551615";
    EXPECT_THAT(refusal("ply\nformat binary_little_endian 1.0\nelement nothing " + most + "\nelement vertex " + most +
                        "\nproperty char x\nproperty char y\nproperty char z\nend_header\n"),
                HasSubstr("the file ends before all the elements"));
    EXPECT_THAT(refusal("ply\nformat binary_big_endian 1.0\nelement tristrips 1\nproperty list uint int vertex_index\n"
                        "end_header\n\xFF\xFF\xFF\xFF"),
                HasSubstr("a list of 4294967295 numbers, but 0 bytes are left"));
}

TEST(PlyWriter, IsReadAlikeByAnIndependentReader) {
    if (testing::run_command("assimp version").code != 0) GTEST_SKIP() << "no assimp here";
    const testing::ScratchDirectory scratch;
    std::ostringstream out;
    write_ply(out, {{"a", testing::octant(3), std::nullopt}, {"b", testing::saddle(1, 2, 3), std::nullopt}});
    testing::write_text(scratch.path("a.ply"), out.str());
    const auto info = testing::run_command("assimp info " + scratch.path("a.ply") + " -r");
    EXPECT_EQ(info.code, 0) << info.output;
    EXPECT_THAT(info.output, ::testing::ContainsRegex("Vertices: +" + std::to_string(10 + 16))) << info.output;
    EXPECT_THAT(info.output, ::testing::ContainsRegex("Faces: +" + std::to_string(9 + 18))) << info.output;
}

}  // namespace ply_test
}  // namespace ripstop
