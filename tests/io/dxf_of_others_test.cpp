/// DXF files as CAD programs write them: what stands in /shared/data/faults/files, its neighbours, and drawings made
/// at random
/// that ezdxf reads too.
#include <gmock/gmock.h>

#include <Eigen/Geometry>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <sstream>

#include "ripstop/base/error.h"
#include "ripstop/io/dxf_read.h"
#include "ripstop/pattern/check_drawing.h"
#include "support/outside.h"
#include "support/shared_data.h"

namespace ripstop {
namespace dxf_of_others_test {

using std::numbers::pi;
using ::testing::HasSubstr;

std::string groups(const std::string& words) {
    std::istringstream in(words);
    std::string text, code, value;
    while (in >> code >> value) text += code + "\n" + value + "\n";
    return text;
}

PatternDrawing read(const std::string& entities, const std::string& before = "") {
    std::istringstream in(groups(before + " 0 SECTION 2 ENTITIES " + entities + " 0 ENDSEC 0 EOF"));
    return read_dxf(in, "a.dxf");
}

DrawingCheck check_of(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return check_drawing(read_dxf(in, file.filename().string()));
}

const DrawingIssue* issue(const DrawingCheck& check, const std::string& code) {
    for (const DrawingIssue& each : check.issues)
        if (each.code == code) return &each;
    return nullptr;
}

double length(const DrawnPath& path) {
    double sum = 0;
    const Eigen::Index count = path.points.rows();
    for (Eigen::Index i = path.is_closed ? 0 : 1; i < count; ++i)
        sum += (path.points.row(i) - path.points.row((i + count - 1) % count)).norm();
    return sum;
}

TEST(DxfOfOthers, NamesABinaryFileAsWhatItIs) {
    RIPSTOP_REQUIRE_SHARED(file, "faults/files/dxf_binary.dxf");
    try {
        check_of(file);
        FAIL() << "accepted";
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("a binary DXF, expected ASCII; save it as ASCII DXF"));
    }
}

TEST(DxfOfOthers, TakesNamesOfBlocksAndLayersWithoutTheirCase) {
    RIPSTOP_REQUIRE_SHARED(file, "faults/files/dxf_block_name_case.dxf");
    EXPECT_EQ(check_of(file).contours.size(), 1U);
    const PatternDrawing found = read("0 LINE 8 Cut 10 0 20 0 11 1 21 0 0 LINE 8 CUT 10 1 20 0 11 1 21 1");
    EXPECT_EQ(found.paths[0].layer, "Cut");
    EXPECT_EQ(found.paths[1].layer, "Cut") << "one layer, as it is first spelt";
}

TEST(DxfOfOthers, PutsLayerZeroOfABlockOnTheLayerOfItsInsert) {
    const std::string blocks =
        "0 SECTION 2 BLOCKS 0 BLOCK 2 IN 0 LINE 8 0 10 0 20 0 11 1 21 0 0 LINE 8 A 10 0 20 0 11 1 21 0 0 ENDBLK "
        "0 BLOCK 2 OUT 0 INSERT 8 0 2 in 0 ENDBLK 0 ENDSEC";
    const PatternDrawing found = read("0 INSERT 8 CUT 2 out 0 INSERT 8 SEW 2 In", blocks);
    ASSERT_EQ(found.paths.size(), 4U);
    EXPECT_EQ(found.paths[0].layer, "CUT") << "through a block in a block";
    EXPECT_EQ(found.paths[1].layer, "A");
    EXPECT_EQ(found.paths[2].layer, "SEW");
}

TEST(DxfOfOthers, LeavesOutWhatIsInvisibleAndSaysSo) {
    RIPSTOP_REQUIRE_SHARED(file, "faults/files/dxf_invisible_entity.dxf");
    const DrawingCheck check = check_of(file);
    EXPECT_TRUE(check.sound());
    EXPECT_EQ(check.contours.size(), 1U);
    ASSERT_NE(issue(check, "unread"), nullptr);
    EXPECT_THAT(issue(check, "unread")->message, HasSubstr("1 invisible POLYLINE on layer CUT"));
}

TEST(DxfOfOthers, LeavesOutLayersThatAreOffOrFrozen) {
    const std::string tables =
        "0 SECTION 2 TABLES 0 TABLE 2 LAYER 0 LAYER 2 OFF 70 0 62 -7 0 LAYER 2 ICE 70 1 62 7 0 ENDTAB 0 ENDSEC";
    const PatternDrawing found =
        read("0 LINE 8 off 11 1 0 LINE 8 ICE 11 1 0 LINE 8 A 11 1 0 CIRCLE 8 OFF 40 1", tables);
    EXPECT_EQ(found.paths.size(), 1U);
    ASSERT_EQ(found.unread.size(), 3U);
    EXPECT_EQ(found.unread[0].kind, "LINE on a hidden layer");
}

TEST(DxfOfOthers, NeverCallsAnOpenOutlineSound) {
    RIPSTOP_REQUIRE_SHARED(file, "faults/files/dxf_layer0_open_outline.dxf");
    const DrawingCheck check = check_of(file);
    EXPECT_FALSE(check.sound());
    EXPECT_EQ(check.open_lines, 1);
    ASSERT_NE(issue(check, "gap"), nullptr);
    EXPECT_THAT(issue(check, "gap")->message, HasSubstr("open by 5.000 mm"));
}

TEST(DxfOfOthers, NotesASideThatTwoPiecesShare) {
    RIPSTOP_REQUIRE_SHARED(file, "faults/files/dxf_common_side_twice.dxf");
    const DrawingCheck check = check_of(file);
    EXPECT_TRUE(check.sound());
    ASSERT_NE(issue(check, "common_side"), nullptr);
    EXPECT_THAT(issue(check, "common_side")->message, HasSubstr("100.0 mm of their outlines in common"));
}

TEST(DxfOfOthers, RefusesAContourThatDoesNotLieInAPlane) {
    RIPSTOP_REQUIRE_SHARED(file, "faults/files/dxf_polyline_in_space.dxf");
    const DrawingCheck check = check_of(file);
    EXPECT_FALSE(check.sound());
    ASSERT_NE(issue(check, "out_of_plane"), nullptr);
    EXPECT_THAT(issue(check, "out_of_plane")->message, HasSubstr("rises by 150.0 mm"));
}

TEST(DxfOfOthers, SeesPlanesInSpaceFromAbove) {
    // A circle that stands upright, by its extrusion along x: from above a line of its diameter.
    const PatternDrawing found = read("0 CIRCLE 8 A 10 0 20 0 40 5 210 1 220 0 230 0");
    ASSERT_EQ(found.paths.size(), 1U);
    EXPECT_NEAR(found.paths[0].high - found.paths[0].low, 10, 1e-3);
    EXPECT_NEAR(found.paths[0].points.col(0).cwiseAbs().maxCoeff(), 0, 1e-12);
    EXPECT_NEAR(found.paths[0].points.col(1).maxCoeff(), 5, 1e-3);
}

TEST(DxfOfOthers, SamplesEllipsesAndSplinesToAChordError) {
    // A quarter of a circle of 1000, exactly, as a rational spline of degree 2.
    const PatternDrawing found = read(
        "0 SPLINE 8 A 70 12 71 2 40 0 40 0 40 0 40 1 40 1 40 1 41 1 41 0.70710678118654757 41 1 "
        "10 1000 20 0 30 0 10 1000 20 1000 30 0 10 0 20 1000 30 0 "
        "0 ELLIPSE 8 A 10 0 20 0 11 2000 21 0 40 0.5 41 0 42 6.2831853071795862 "
        "0 LWPOLYLINE 8 A 70 1 10 -50000 20 0 42 1 10 50000 20 0 42 1");
    ASSERT_EQ(found.paths.size(), 3U);
    EXPECT_NEAR(length(found.paths[0]), 500 * pi, 0.01);
    for (Eigen::Index i = 0; i < found.paths[0].points.rows(); ++i)
        EXPECT_NEAR(found.paths[0].points.row(i).norm(), 1000, 1e-9);
    for (Eigen::Index i = 0; i + 1 < found.paths[0].points.rows(); ++i)
        EXPECT_LE(1000 - (found.paths[0].points.row(i) + found.paths[0].points.row(i + 1)).norm() / 2, 0.002);
    EXPECT_TRUE(found.paths[1].is_closed);
    // Half axes of 2000 and 1000: 4 a E(1 - 1/4).
    EXPECT_NEAR(length(found.paths[1]), 4 * 2000 * 1.2110560275684594, 0.05);
    const Points2& large = found.paths[2].points;
    for (Eigen::Index i = 0; i + 1 < large.rows(); ++i)
        EXPECT_LE(50000 - (large.row(i) + large.row(i + 1)).norm() / 2, 0.0021) << "a point a degree is 1.9 off";
}

TEST(DxfOfOthers, NamesASplineWithoutControlPoints) {
    const PatternDrawing found = read("0 SPLINE 8 A 71 3 11 0 21 0 11 1 21 1 11 2 21 0 0 SPLINE 8 A 71 3 10 0 20 0");
    EXPECT_TRUE(found.paths.empty());
    ASSERT_EQ(found.unread.size(), 1U);
    EXPECT_EQ(found.unread[0].kind, "SPLINE without control points");
    EXPECT_FALSE(check_drawing(found).sound());
}

/// What is drawn on a layer, whatever lines it is made of.
struct LayerSum {
    double length = 0;
    Eigen::AlignedBox3d box;
};

std::map<std::string, LayerSum> sums_of(const PatternDrawing& drawing) {
    std::map<std::string, LayerSum> sums;
    for (const DrawnPath& path : drawing.paths) {
        std::string layer = path.layer;
        for (char& c : layer) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
        LayerSum& sum = sums[layer];
        sum.length += length(path);
        const Vec2 lower = path.points.colwise().minCoeff(), upper = path.points.colwise().maxCoeff();
        sum.box.extend(Vec3(lower.x(), lower.y(), path.low));
        sum.box.extend(Vec3(upper.x(), upper.y(), path.high));
    }
    return sums;
}

TEST(DxfOfOthers, AreReadAsEzdxfReadsThem) {
    const std::string python = testing::python_with("ezdxf");
    if (python.empty()) GTEST_SKIP() << "no Python with ezdxf here";
    const testing::ScratchDirectory scratch;
    constexpr int count = 100;
    const auto made = testing::run_command(python + " " RIPSTOP_SOURCE_DIR "/tests/dxf/generate.py " + scratch.path() +
                                           " " + std::to_string(count));
    ASSERT_EQ(made.code, 0) << made.output;
    std::istringstream in(made.output);
    int number = 0, layers = 0, known = -1;
    std::string layer;
    double total = 0;
    Vec3 lower, upper;
    std::map<std::string, LayerSum> sums;
    while (in >> number >> layer >> total >> lower.x() >> lower.y() >> upper.x() >> upper.y() >> lower.z() >>
           upper.z()) {
        if (number != known) {
            std::ifstream file(scratch.path(std::to_string(number) + ".dxf"));
            sums = sums_of(read_dxf(file, std::to_string(number) + ".dxf"));
            known = number;
        }
        ++layers;
        ASSERT_TRUE(sums.contains(layer)) << number << " " << layer;
        // A point a degree makes an arc shorter by 1.3e-5. The chord error of ezdxf is 0.02, by which it makes a
        // curve of radius r
        // shorter by a third of 0.02 / r.
        EXPECT_GT(sums[layer].length, total * (1 - 2e-5) - 0.02) << number << " " << layer;
        EXPECT_LT(sums[layer].length, total * (1 + 5e-4) + 0.3) << number << " " << layer;
        EXPECT_LE((sums[layer].box.min() - lower).cwiseAbs().maxCoeff(), 0.022) << number << " " << layer;
        EXPECT_LE((sums[layer].box.max() - upper).cwiseAbs().maxCoeff(), 0.022) << number << " " << layer;
    }
    EXPECT_GE(layers, count);
}

}  // namespace dxf_of_others_test
}  // namespace ripstop
