#include "ripstop/io/rhino/rhino_3dm.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <set>
#include <sstream>

#include "ripstop/base/error.h"
#include "ripstop/io/mesh/mesh_file.h"
#include "support/outside.h"
#include "support/refusal.h"
#include "support/rhino.h"
#include "support/shapes.h"
#include "support/shared_data.h"

namespace ripstop {
namespace rhino_3dm_test {

using ::testing::AllOf;
using ::testing::Contains;
using testing::content;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Pair;
using testing::ScratchDirectory;
using ::testing::StartsWith;
using Json = nlohmann::json;

const std::string fixtures = RIPSTOP_SOURCE_DIR "/tests/data/rhino/";

CadModel read(const std::string& bytes) {
    std::istringstream in(bytes);
    return read_rhino_3dm(in, "tiles.3dm");
}

std::string refusal(const std::string& bytes) {
    return testing::refusal([&] { read(bytes); });
}

const NamedMesh& surface_of(const CadModel& model, const std::string& name) {
    for (const NamedMesh& surface : model.surfaces)
        if (surface.name == name) return surface;
    throw std::runtime_error("no surface " + name);
}

const NamedCurve& curve_of(const CadModel& model, const std::string& name) {
    for (const NamedCurve& curve : model.curves)
        if (curve.name == name) return curve;
    throw std::runtime_error("no curve " + name);
}

std::vector<std::string> names_of(const CadModel& model) {
    std::vector<std::string> names;
    for (const NamedMesh& surface : model.surfaces) names.push_back(surface.name);
    return names;
}

Vec3 area_of(const NamedMesh& surface) {
    return area_vector(surface.mesh);
}

class EveryRhino : public ::testing::TestWithParam<int> {
  protected:
    static std::string bytes() { return content(fixtures + "tiles_v" + std::to_string(GetParam()) + ".3dm"); }
    static bool has_blocks() { return GetParam() > 2; }     // openNURBS writes no definitions for Rhino 2
    static bool has_user_text() { return GetParam() > 3; }  // nor user text of attributes before Rhino 4
    static bool has_sublayers() { return GetParam() > 4; }  // sublayers are renamed before Rhino 5
    static bool has_doubles() { return GetParam() > 4; }
};

TEST_P(EveryRhino, GivesNamesLayersAndWhatWasWrittenBeside) {
    const CadModel model = read(bytes());
    ASSERT_TRUE(model.unit);
    EXPECT_EQ(model.unit->name, "in");
    EXPECT_EQ(model.unit->metres, 0.0254);
    ASSERT_EQ(model.layers.size(), 5u);
    EXPECT_THAT(model.layers[2], StartsWith("Gores::G01"));
    if (has_sublayers()) {
        EXPECT_EQ(model.layers[2], "Gores::G01");
    }
    const Attributes& said = surface_of(model, "G01P01").attributes;
    EXPECT_THAT(said, Contains(Pair("layer", model.layers[2])));
    EXPECT_THAT(said, Contains(Pair("group", "crown ring")));
    if (has_user_text()) {
        EXPECT_THAT(said, AllOf(Contains(Pair("fabric", "nylon")), Contains(Pair("H\xC3\xB6he", "3 m")),
                                Contains(Pair("made", "by hand"))));
    }
    EXPECT_EQ(std::count_if(model.surfaces.begin(), model.surfaces.end(),
                            [](const NamedMesh& s) { return s.name == (has_user_text() ? "renamed" : "plain"); }),
              1)
        << "the user text `tile` goes before the name";
    EXPECT_THAT(curve_of(model, "curve_01").attributes, Contains(Pair("layer", "GRAIN")));
}

TEST_P(EveryRhino, KeepsDoublesWhereTheFileHasThem) {
    const Points3 points = surface_of(read(bytes()), "G01P01").mesh.positions;
    Points3 written(5, 3);
    written << 0.1, 0.2, 0.3, 10.123456789012345, 0, 0, 10, 10, 3, 0, 10, 0, 20, 5, 1.0 / 3;
    if (has_doubles())
        EXPECT_EQ(points, written);
    else
        EXPECT_EQ(points, written.cast<float>().cast<double>());
}

TEST_P(EveryRhino, LeavesOutWhatIsNotShownAndSaysSo) {
    const CadModel model = read(bytes());
    EXPECT_EQ(model.surfaces.size(), has_blocks() ? 4u : 2u) << ::testing::PrintToString(names_of(model));
    EXPECT_THAT(model.remarks, Contains(StartsWith("1 object on the hidden layer \"Off\" left out")));
    EXPECT_THAT(model.remarks, Contains(StartsWith("1 hidden object left out")));
    if (GetParam() > 3) {
        EXPECT_THAT(model.remarks, Contains(StartsWith("1 object on layouts left out")));
    }
    if (!has_blocks()) {
        ASSERT_EQ(model.unread.size(), 2u);
        EXPECT_EQ(model.unread[0].type, "Block");
        EXPECT_THAT(model.unread[0].reason, HasSubstr("not in the file"));
    }
}

TEST_P(EveryRhino, PlacesBlocksInBlocksAndKeepsTheOutsideOfMirroredOnes) {
    if (!has_blocks()) GTEST_SKIP() << "no blocks in a file of Rhino 2";
    const CadModel model = read(bytes());
    // x' = 7 - x of a panel whose corner 2 is lifted by 1/4: its outside, +z, stays on top.
    const NamedMesh& mirror = surface_of(model, "mirror/inner");
    EXPECT_GT(area_of(mirror).z(), 0.9);
    EXPECT_EQ(mirror.mesh.positions.row(2), Eigen::RowVector3d(6, 1, 0.25));
    // Lifted by 5, then rotated by 90 degrees about z and moved by 3.
    const NamedMesh& nested = surface_of(model, "pair_01/up/inner");
    EXPECT_EQ(nested.mesh.positions.row(1), Eigen::RowVector3d(3, 1, 5));
    EXPECT_GT(area_of(nested).z(), 0.9);
    const NamedCurve& curve = curve_of(model, "pair_01");
    EXPECT_EQ(curve.points.row(2), Eigen::RowVector3d(2, 1, 5));
}

TEST_P(EveryRhino, CutShortAnywhereIsRefused) {
    const std::string whole = bytes();
    for (std::size_t length = 0; length < whole.size(); ++length)
        ASSERT_THAT(refusal(whole.substr(0, length)), StartsWith("tiles.3dm: byte ")) << length;
}

TEST_P(EveryRhino, WithAnyBitTurnedIsAModelOrARefusal) {
    const std::string whole = bytes();
    for (std::size_t at = 0; at < whole.size(); ++at) {
        std::string bytes = whole;
        bytes[at] = static_cast<char>(bytes[at] ^ (1 << at % 8));
        try {
            for (const NamedMesh& surface : read(bytes).surfaces) {
                ASSERT_TRUE(surface.mesh.positions.allFinite());
                ASSERT_GE(surface.mesh.triangles.minCoeff(), 0);
                ASSERT_LT(surface.mesh.triangles.maxCoeff(), surface.mesh.vertex_count());
            }
        } catch (const InputError& error) {
            ASSERT_THAT(error.what(), StartsWith("tiles.3dm: "));
        }
    }
}

INSTANTIATE_TEST_SUITE_P(, EveryRhino, ::testing::Range(2, 9),
                         [](const auto& version) { return "Rhino" + std::to_string(version.param); });

TEST(Rhino3dm, GivesCurvesToATenthOfAPercentOfTheirSize) {
    for (const char* file : {"curves_v2.3dm", "curves_v5.3dm", "curves_v8.3dm"}) {
        const CadModel model = read(content(fixtures + file));
        EXPECT_EQ(model.unit->metres, 0.3048);
        EXPECT_EQ(curve_of(model, "loop").points.rows(), 4);
        // The half circle about (1, 0) through (1, 1), as an arc and as a rational NURBS: chords lie inside it.
        for (const char* name : {"bow", "conic"}) {
            const Points3& points = curve_of(model, name).points;
            EXPECT_LT((points.row(0) - Eigen::RowVector3d(0, 0, 0)).norm(), 1e-12);
            EXPECT_LT((points.row(points.rows() - 1) - Eigen::RowVector3d(2, 0, 0)).norm(), 1e-12);
            for (Eigen::Index i = 0; i < points.rows(); ++i)
                EXPECT_NEAR((points.row(i) - Eigen::RowVector3d(1, 0, 0)).norm(), 1, 1e-12) << name;
            for (Eigen::Index i = 1; i < points.rows(); ++i)
                EXPECT_LT(1 - ((points.row(i) + points.row(i - 1)) / 2 - Eigen::RowVector3d(1, 0, 0)).norm(), 0.002)
                    << name;
        }
        // A clamped cubic: it ends at its first and last control points, with the polygon's tangents.
        const Points3& wave = curve_of(model, "wave").points;
        EXPECT_LT((wave.row(0) - Eigen::RowVector3d(0, 0, 0)).norm(), 1e-12);
        EXPECT_LT((wave.row(wave.rows() - 1) - Eigen::RowVector3d(4, 1, 0)).norm(), 1e-12);
        const Points3& joined = curve_of(model, "joined").points;
        EXPECT_EQ(joined.row(0), Eigen::RowVector3d(0, 0, 0));
        EXPECT_LT((joined.row(joined.rows() - 1) - Eigen::RowVector3d(1, 2, 0)).norm(), 1e-12);
    }
}

TEST(Rhino3dm, NamesWhatItCannotRead) {
    const CadModel model = read(content(fixtures + "curves_v8.3dm"));
    EXPECT_TRUE(model.surfaces.empty());
    ASSERT_EQ(model.unread.size(), 2u);
    EXPECT_EQ(model.unread[0].name, "wall");
    EXPECT_EQ(model.unread[0].type, "Extrusion");
    EXPECT_THAT(model.unread[0].reason, HasSubstr("mesh it in Rhino"));
    EXPECT_EQ(model.unread[1].type, "PointCloud");
    EXPECT_THAT(model.remarks, ElementsAre("left out because they are not surfaces: 1 Point, 1 TextDot"));
}

TEST(Rhino3dm, SaysWhatToDoWithAFileOfAnotherKind) {
    EXPECT_THAT(refusal("v 0 0 0\n"), HasSubstr("not the beginning of a Rhino file"));
    EXPECT_THAT(refusal("3D Geometry File Format        x"), HasSubstr("byte 24: \"x\" where the version belongs"));
    EXPECT_THAT(refusal("3D Geometry File Format       90"), HasSubstr("written by Rhino 9"));
    const CadModel first = read("3D Geometry File Format        1 and more");
    ASSERT_EQ(first.unread.size(), 1u);
    EXPECT_EQ(first.unread[0].type, "Rhino 1 model");
}

TEST(Rhino3dm, JoinsTheVerticesOfAnUnweldedMeshAndSaysSo) {
    const CadModel model = read(content(RIPSTOP_SOURCE_DIR "/fuzz/corpus/rhino_3dm/unwelded_v8.3dm"));
    ASSERT_EQ(model.surfaces.size(), 1u);
    EXPECT_EQ(model.surfaces[0].name, "Default") << "the only surface on its layer is called like it";
    EXPECT_EQ(model.surfaces[0].mesh.vertex_count(), 4) << "two of six are doubled, one is not used";
    EXPECT_THAT(model.remarks, ElementsAre(HasSubstr("2 vertices were merged with others in the same place")));
}

TEST(Rhino3dm, SplitsAQuadSoThatBothTrianglesFaceOneWayAndLeavesOutFacesOfTwoCorners) {
    // A dart: of its diagonals, only the one from the reflex corner, vertex 2, lies inside.
    const CadModel model = read(content(RIPSTOP_SOURCE_DIR "/fuzz/corpus/rhino_3dm/narrow_v8.3dm"));
    ASSERT_EQ(model.surfaces.size(), 1u);
    Triangles expected(2, 3);
    expected << 0, 1, 2, 0, 2, 3;
    EXPECT_EQ(model.surfaces[0].mesh.triangles, expected);
    EXPECT_THAT(model.remarks, ElementsAre("kite: 1 face without three different corners left out"));
}

/// The offset in a file of the only bytes equal to `value`.
template <class T>
std::size_t place_of(const std::string& bytes, const T& value) {
    std::string pattern(sizeof(T), '\0');
    std::memcpy(pattern.data(), &value, sizeof(T));
    const std::size_t at = bytes.find(pattern);
    EXPECT_NE(at, std::string::npos);
    EXPECT_EQ(bytes.find(pattern, at + 1), std::string::npos);
    return at;
}

TEST(Rhino3dm, RefusesAFaceAtAVertexThatIsNotThereByTheNameOfItsMesh) {
    std::string bytes = content(RIPSTOP_SOURCE_DIR "/fuzz/corpus/rhino_3dm/mesh_v8.3dm");
    bytes[place_of(bytes, std::array<unsigned char, 8>{1, 0, 0, 0, 0, 1, 2, 3}) + 7] = 9;  // corners of one byte each
    EXPECT_THAT(refusal(bytes),
                StartsWith("tiles.3dm: Mesh \"a\": face 1 has the vertex 9 of 4, counted from 0; repair"));
}

TEST(Rhino3dm, RefusesABlockThatSaysItUnpacksToMoreThanItCan) {
    // A packed net of 5 x 5 vertices: the counts of vertices and of unpacked bytes are replaced by those of a
    // decompression bomb.
    std::string bytes = content(RIPSTOP_SOURCE_DIR "/fuzz/corpus/rhino_3dm/packed_v2.3dm");
    EXPECT_EQ(read(bytes).surfaces.at(0).mesh.vertex_count(), 25);
    const std::size_t counts = place_of(bytes, std::array<std::int32_t, 2>{25, 16});
    const std::size_t block = place_of(bytes, std::array<std::uint8_t, 8>{18, 19, 24, 23, 0x2C, 1, 0, 0}) + 4;
    const std::uint32_t vertices = 300000000, size = vertices * 12U;
    std::memcpy(bytes.data() + counts, &vertices, 4);
    std::memcpy(bytes.data() + block, &size, 4);
    EXPECT_THAT(refusal(bytes), HasSubstr("3600000000 bytes supposedly packed into "));
}

TEST(Rhino3dm, RefusesVerticesThatAreNotWhatTheirChecksumSays) {
    std::string bytes = content(RIPSTOP_SOURCE_DIR "/fuzz/corpus/rhino_3dm/mesh_v2.3dm");
    bytes[place_of(bytes, 1.123456789F)] ^= 1;
    EXPECT_THAT(refusal(bytes), HasSubstr("a block that does not match its checksum"));
}

TEST(Rhino3dm, RefusesABlockThatHoldsItself) {
    // The nested block refers to its own definition: the ids of both instances become equal.
    std::string bytes = content(RIPSTOP_SOURCE_DIR "/fuzz/corpus/rhino_3dm/nested_v8.3dm");
    std::vector<std::size_t> places;  // of instances: version 1.0, id, then the transformation, which begins with 1.0
    const std::string map(
        "\0\0\0\0\0\0\xF0\x3F\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\xF0\x3F", 48);
    for (std::size_t at = bytes.find(map); at != std::string::npos; at = bytes.find(map, at + 1))
        if (bytes[at - 17] == 0x10) places.push_back(at - 16);
    ASSERT_EQ(places.size(), 2u);
    for (std::size_t k = 0; k < 16; ++k) bytes[places[0] + k] = bytes[places[1] + k];
    EXPECT_THAT(refusal(bytes), HasSubstr("the block contains itself"));
}

void expect_as_rhino_says(const std::string& file) {
    const Json says = testing::described_by_rhino(file);
    std::ifstream in(file, std::ios::binary);
    const CadModel model = read_rhino_3dm(in, std::string(file));  // without openNURBS
    std::vector<std::string> layers;
    for (const Json& layer : says["layers"]) layers.push_back(layer["path"]);
    EXPECT_EQ(model.layers, layers) << file;
    std::size_t shown = 0, surface = 0, others = 0;
    std::map<std::string, std::vector<const NamedMesh*>> by_layer;
    for (const Json& object : says["objects"]) {
        const Json& layer = says["layers"][object["layer"].get<std::size_t>()];
        if (object["mode"] == 3 || object["mode"] == 1 || !object["visible"] || !layer["visible"]) continue;
        ++shown;
        const std::string type = object["type"];
        if (type != "Mesh") {
            if (type == "Brep" || type == "Extrusion" || type == "SubD" || type == "PointCloud") ++others;
            continue;
        }
        ASSERT_LT(surface, model.surfaces.size()) << file;
        const NamedMesh& found = model.surfaces[surface++];
        EXPECT_THAT(found.name, HasSubstr(object["name"])) << "or it has none";
        EXPECT_EQ(found.attributes.at("layer"), layer["path"]);
        EXPECT_EQ(found.attributes.contains("group"), !object["groups"].empty());
        for (const auto& [key, value] : object["text"].items()) EXPECT_EQ(found.attributes.at(key), value);
        EXPECT_EQ(found.mesh.triangle_count(), object["triangles"]);
        // The program merges coincident vertices, but every place of a vertex must remain.
        EXPECT_LE(found.mesh.vertex_count(), object["vertices"]);
        for (int k = 0; k < 3; ++k) {
            const double low = object["box"][0][k], high = object["box"][1][k];
            EXPECT_NEAR(found.mesh.positions.col(k).minCoeff(), low, 1e-6 * (1 + std::abs(low)));
            EXPECT_NEAR(found.mesh.positions.col(k).maxCoeff(), high, 1e-6 * (1 + std::abs(high)));
        }
    }
    EXPECT_EQ(model.unread.size(), others) << file;
}

TEST(Rhino3dm, GivesOfEveryFileOfOthersWhatOpenNurbsSays) {
    RIPSTOP_REQUIRE_SHARED(folder, "rhino");
    RIPSTOP_REQUIRE_RHINO();
    int files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.path().extension() == ".3dm") {
            expect_as_rhino_says(entry.path());
            ++files;
        }
    EXPECT_GE(files, 7);
}

TEST(Rhino3dm, GivesOfWhatOpenNurbsWritesWhatItSays) {
    RIPSTOP_REQUIRE_RHINO();
    for (const char* file : {"tiles_v4.3dm", "tiles_v6.3dm", "curves_v8.3dm"}) {
        const Json says = testing::described_by_rhino(fixtures + file);
        const CadModel model = read_model(fixtures + file);
        for (const Json& object : says["objects"]) {
            if (!object.contains("start") || object["name"].get<std::string>().empty()) continue;
            const Points3& points = curve_of(model, object["name"]).points;
            for (int k = 0; k < 3; ++k) {
                // rhino3dm gives ends in double precision; ours are evaluated with another formula.
                EXPECT_NEAR(points(0, k), object["start"][k], 1e-12);
                EXPECT_NEAR(points(points.rows() - 1, k), object["end"][k], 1e-12);
            }
        }
    }
}

Json mesh_object(const TriangleMesh& mesh, const std::string& name) {
    Json object = {{"kind", "mesh"}, {"name", name}};
    for (Eigen::Index v = 0; v < mesh.positions.rows(); ++v)
        object["vertices"].push_back({mesh.positions(v, 0), mesh.positions(v, 1), mesh.positions(v, 2)});
    for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t)
        object["faces"].push_back({mesh.triangles(t, 0), mesh.triangles(t, 1), mesh.triangles(t, 2)});
    return object;
}

TEST(Rhino3dm, GivesBackExactlyTheMeshesOpenNurbsWasGiven) {
    RIPSTOP_REQUIRE_RHINO();
    const ScratchDirectory scratch;
    const TriangleMesh saddle = testing::moved(testing::saddle(1.0 / 3, 0.7, 30));  // corners of two bytes each
    Json scene = {{"layers", {{{"name", "Default"}}}}, {"objects", {mesh_object(saddle, "saddle")}}};
    testing::write_by_rhino(scene, scratch.path("saddle.json"), {3, 5, 6, 8});
    for (const int version : {3, 5, 6, 8}) {
        const CadModel model = read_model(scratch.path("saddle_v" + std::to_string(version) + ".3dm"));
        ASSERT_EQ(model.surfaces.size(), 1u);
        EXPECT_EQ(model.surfaces[0].mesh.triangles, saddle.triangles);
        if (version < 5)
            EXPECT_EQ(model.surfaces[0].mesh.positions, saddle.positions.cast<float>().cast<double>());
        else
            EXPECT_EQ(model.surfaces[0].mesh.positions, saddle.positions);
    }
}

TEST(Rhino3dm, CallsATileByTheTextOfTheBlockThatHoldsItAlone) {
    EXPECT_THAT(names_of(read(content(fixtures + "block_tile_text_v7.3dm"))), ElementsAre("ONE", "TWO"));
}

TEST(Rhino3dm, CallsTilesByTheTextOfBlocksInBlocksAndSaysWhichTextNamesNone) {
    RIPSTOP_REQUIRE_RHINO();
    const ScratchDirectory scratch;
    const auto block = [](const std::string& name, const std::string& of, double x, const std::string& tile) {
        Json object = {{"kind", "block"},
                       {"definition", of},
                       {"name", name},
                       {"xform", {1, 0, 0, x, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}};
        if (!tile.empty()) object["text"] = {{"tile", tile}};
        return object;
    };
    const Json single = {{"name", "single"}, {"objects", {mesh_object(testing::rectangle(1, 1, 1, 1), "A")}}};
    const Json twice = {{"name", "twice"},
                        {"objects", {block("left", "single", 0, "L"), block("right", "single", 2, "")}}};
    const Json outer = {{"name", "outer"}, {"objects", {block("inner", "single", 0, "within")}}};
    const Json scene = {{"layers", {{{"name", "Default"}}}},
                        {"definitions", {single, twice, outer}},
                        {"objects",
                         {block("I1", "twice", 0, "PAIR"), block("", "twice", 10, "CROWN"),
                          block("I3", "outer", 20, "THREE"), block("I4", "outer", 30, "")}}};
    testing::write_by_rhino(scene, scratch.path("blocks.json"), {7});
    const CadModel model = read_model(scratch.path("blocks_v7.3dm"));
    // A block without its own name takes its text as name, which counts as use.
    EXPECT_THAT(names_of(model), ElementsAre("I1/L", "I1/right/A", "CROWN/L", "CROWN/right/A", "THREE", "I4/within"));
    EXPECT_THAT(model.remarks, ElementsAre(StartsWith("I1 (\"PAIR\"): the user text tile of a block names no tile")));
}

}  // namespace rhino_3dm_test
}  // namespace ripstop
