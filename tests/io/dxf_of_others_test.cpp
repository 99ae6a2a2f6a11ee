/// DXF files as CAD programs write them: those in /shared/data/faults/files, similar ones, and random drawings
/// that ezdxf reads too.
#include <gmock/gmock.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <numbers>
#include <sstream>

#include "ripstop/base/error.h"
#include "ripstop/io/dxf/dxf_read.h"
#include "ripstop/pattern/drawing/check_drawing.h"
#include "support/outside.h"
#include "support/sanitized.h"
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
    EXPECT_THAT(issue(check, "common_side")->message, HasSubstr("share 100.0 mm of their outlines"));
}

TEST(DxfOfOthers, RefusesAContourThatDoesNotLieInAPlane) {
    RIPSTOP_REQUIRE_SHARED(file, "faults/files/dxf_polyline_in_space.dxf");
    const DrawingCheck check = check_of(file);
    EXPECT_FALSE(check.sound());
    ASSERT_NE(issue(check, "out_of_plane"), nullptr);
    EXPECT_THAT(issue(check, "out_of_plane")->message, HasSubstr("rises by 150.0 mm"));
}

TEST(DxfOfOthers, SeesPlanesInSpaceFromAbove) {
    // An upright circle, with its extrusion along x: from above it is a line as long as its diameter.
    const PatternDrawing found = read("0 CIRCLE 8 A 10 0 20 0 40 5 210 1 220 0 230 0");
    ASSERT_EQ(found.paths.size(), 1U);
    EXPECT_NEAR(found.paths[0].high - found.paths[0].low, 10, 1e-3);
    EXPECT_NEAR(found.paths[0].points.col(0).cwiseAbs().maxCoeff(), 0, 1e-12);
    EXPECT_NEAR(found.paths[0].points.col(1).maxCoeff(), 5, 1e-3);
}

TEST(DxfOfOthers, SamplesEllipsesAndSplinesToAChordError) {
    // A quarter of a circle of radius 1000, exactly, as a rational spline of degree 2.
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
    const PatternDrawing found = read("0 SPLINE 8 A 71 3 11 0 21 0 0 SPLINE 8 A 71 3 10 0 20 0");
    EXPECT_TRUE(found.paths.empty());
    ASSERT_EQ(found.unread.size(), 1U);
    EXPECT_EQ(found.unread[0].kind, "SPLINE without control points");
    EXPECT_FALSE(check_drawing(found).sound());
}

TEST(DxfOfOthers, DrawsASplineThroughItsPoints) {
    // Two points with tangents give a cubic whose middle is chord / 8 off the chord, here as a bow.
    const PatternDrawing found = read(
        "0 SPLINE 8 A 71 3 11 0 21 0 11 80 21 0 12 0 22 5 13 0 23 -1 0 SPLINE 8 A 71 3 11 0 21 0 11 1 21 1 11 2 21 2 "
        "0 SPLINE 8 A 70 1 71 3 11 0 21 0 11 9 21 0 11 9 21 9 11 0 21 0");
    ASSERT_EQ(found.paths.size(), 3U);
    EXPECT_NEAR(found.paths[0].points.col(1).maxCoeff(), 20, 1e-3);
    EXPECT_NEAR(length(found.paths[1]), std::hypot(2, 2), 1e-9) << "points in a row are a line";
    EXPECT_TRUE(found.paths[2].is_closed);
}

TEST(DxfOfOthers, GivesASplineWithoutKnotsThoseOfItsEnds) {
    const PatternDrawing found = read("0 SPLINE 8 A 71 2 10 0 20 0 10 5 20 10 10 10 20 0");
    ASSERT_EQ(found.paths.size(), 1U);
    EXPECT_NEAR(found.paths[0].points.col(1).maxCoeff(), 5, 2e-3) << "a parabola";
}

TEST(DxfOfOthers, DrawsAnArrayWithoutDistancesOnce) {
    const std::string block = "0 SECTION 2 BLOCKS 0 BLOCK 2 B 0 LINE 8 0 11 1 21 0 0 ENDBLK 0 ENDSEC";
    EXPECT_EQ(read("0 INSERT 8 A 2 B 70 3 71 4", block).paths.size(), 1U);
    EXPECT_EQ(read("0 INSERT 8 A 2 B 70 3 71 4 44 5", block).paths.size(), 3U);
    EXPECT_EQ(read("0 INSERT 8 A 2 B 70 3 71 4 44 5 45 -5", block).paths.size(), 12U);
}

TEST(DxfOfOthers, ShowsOfABlockOnALayerThatIsOffWhatIsOnOthers) {
    const std::string before =
        "0 SECTION 2 TABLES 0 TABLE 2 LAYER 0 LAYER 2 OFF 70 0 62 -7 0 LAYER 2 ICE 70 1 62 7 0 ENDTAB 0 ENDSEC "
        "0 SECTION 2 BLOCKS 0 BLOCK 2 B 0 LINE 8 0 11 1 0 LINE 8 CUT 11 2 0 ENDBLK 0 ENDSEC";
    const PatternDrawing found = read("0 INSERT 8 OFF 2 B 0 INSERT 8 ICE 2 B", before);
    ASSERT_EQ(found.paths.size(), 1U) << "what is frozen is not shown at all";
    EXPECT_EQ(found.paths[0].layer, "CUT");
    ASSERT_EQ(found.unread.size(), 2U);
    EXPECT_EQ(found.unread[0].kind, "LINE on a hidden layer");
    EXPECT_EQ(found.unread[1].kind, "INSERT on a hidden layer");
}

TEST(DxfOfOthers, TurnsTextsWithTheirBlock) {
    const std::string block =
        "0 SECTION 2 BLOCKS 0 BLOCK 2 B 0 TEXT 8 0 1 a 10 1 20 0 40 2 50 30 0 MTEXT 8 0 1 b 10 0 20 1 40 2 11 0 21 1 "
        "0 TEXT 8 0 1 c 10 3 20 0 40 2 72 5 11 9 21 0 0 ENDBLK 0 ENDSEC";
    const PatternDrawing found = read("0 INSERT 8 A 2 B 41 3 42 3 43 3 50 45", block);
    ASSERT_EQ(found.texts.size(), 3U);
    EXPECT_NEAR(found.texts[0].turn, 75, 1e-9);
    EXPECT_NEAR(found.texts[0].height, 6, 1e-9);
    EXPECT_NEAR(found.texts[1].turn, 135, 1e-9) << "by its direction";
    EXPECT_NEAR(found.texts[2].at.norm(), 9, 1e-9) << "between two points: from the first";
}

TEST(DxfOfOthers, ReadsNamesInTheCodePageOfTheFile) {
    const auto header = [](const std::string& page) {
        return "0 SECTION 2 HEADER 9 $DWGCODEPAGE 3 " + page + " 0 ENDSEC";
    };
    EXPECT_EQ(read("0 LINE 8 \xD0\xF3\xEA 11 1", header("ANSI_1251")).paths[0].layer, "Рук");
    EXPECT_EQ(read("0 LINE 8 N\xE4hte 11 1", header("ANSI_1252")).paths[0].layer, "Nähte");
    EXPECT_EQ(read("0 LINE 8 N\xE4hte 11 1").paths[0].layer, "Nähte") << "says nothing";
    EXPECT_EQ(read("0 LINE 8 Nähte 11 1", header("ANSI_1251")).paths[0].layer, "Nähte") << "is UTF-8 all the same";
    EXPECT_EQ(read("0 LINE 8 N\\U+00E4hte 11 1").paths[0].layer, "Nähte");
    EXPECT_EQ(read("0 LINE 8 C:\\U+xyz 11 1").paths[0].layer, "C:\\U+xyz") << "no code";
}

TEST(DxfOfOthers, TakesNamesBeyondAsciiWithoutTheirCase) {
    const std::string block = "0 SECTION 2 BLOCKS 0 BLOCK 2 Ärmel_Čω_Рукав 0 LINE 8 0 11 1 0 ENDBLK 0 ENDSEC";
    EXPECT_EQ(read("0 INSERT 8 A 2 ÄRMEL_čΩ_рУКАВ", block).paths.size(), 1U);
}

TEST(DxfOfOthers, LeavesOutCommentsWhereverTheyStand) {
    const PatternDrawing found =
        read("999 first 0 LINE 8 A 999 between 11 1 999 last", "999 made 0 SECTION 999 of 2 HEADER 999 a 0 ENDSEC");
    EXPECT_EQ(found.paths.size(), 1U);
    EXPECT_EQ(found.comment, "made");
}

double turn_of(const Points2& points) {
    double turn = 0;
    Vec2 before = Vec2::Zero();
    for (Eigen::Index i = 1; i < points.rows(); ++i) {
        const Vec2 step = points.row(i) - points.row(i - 1);
        if (step.norm() == 0) continue;
        if (before.norm() > 0) turn += std::acos(std::clamp(before.normalized().dot(step.normalized()), -1.0, 1.0));
        before = step;
    }
    return turn;
}

double distance_to(const DrawnPath& path, const Vec2& point) {
    double least = std::numeric_limits<double>::infinity();
    const Eigen::Index count = path.points.rows();
    for (Eigen::Index i = path.is_closed ? 0 : 1; i < count; ++i) {
        const Vec2 from = path.points.row((i + count - 1) % count), along = Vec2(path.points.row(i)) - from;
        const double square = along.squaredNorm();
        const double share = square > 0 ? std::clamp((point - from).dot(along) / square, 0.0, 1.0) : 0;
        least = std::min(least, (from + share * along - point).norm());
    }
    return least;
}

std::string layer_key(std::string layer) {
    for (char& c : layer) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return layer == "NäHTE" ? "NÄHTE" : layer;
}

/// Both consist of chords of the same curve: ours within 0.002 of it, those of ezdxf within 0.004.
constexpr double both_chords = 0.0062;

void expect_line(const DrawnPath& path, std::istream& in, const std::string& where) {
    std::string layer;
    int is_closed = 0;
    double total = 0;
    Vec3 low, high;
    in >> layer >> is_closed >> total >> low.x() >> low.y() >> low.z() >> high.x() >> high.y() >> high.z();
    EXPECT_EQ(layer_key(path.layer), layer) << where;
    EXPECT_EQ(path.is_closed, is_closed == 1) << where;
    // Chords within e of a curve that turns by t are shorter than it by up to e t / 3.
    EXPECT_NEAR(length(path), total, both_chords / 3 * turn_of(path.points) + 1e-3) << where;
    const Vec2 lower = path.points.colwise().minCoeff(), upper = path.points.colwise().maxCoeff();
    EXPECT_LE((Vec3(lower.x(), lower.y(), path.low) - low).cwiseAbs().maxCoeff(), both_chords) << where;
    EXPECT_LE((Vec3(upper.x(), upper.y(), path.high) - high).cwiseAbs().maxCoeff(), both_chords) << where;
    int points = 0;
    for (Vec3 at; in >> at.x() >> at.y() >> at.z(); ++points)
        EXPECT_LE(distance_to(path, at.head<2>()), both_chords) << where << " at " << at.transpose();
    EXPECT_EQ(points, 24) << where;
}

void expect_text(const DrawnText& text, std::istream& in, const std::string& where) {
    std::string layer;
    Vec2 at;
    double height = 0, turn = 0;
    in >> layer >> at.x() >> at.y() >> height >> turn;
    EXPECT_EQ(layer_key(text.layer), layer) << where;
    EXPECT_LE((text.at - at).norm(), 1e-6) << where;
    EXPECT_NEAR(text.height, height, 1e-6) << where;
    EXPECT_NEAR(std::remainder(text.turn - turn, 360), 0, 1e-6) << where;
}

TEST(DxfOfOthers, AreReadAsEzdxfReadsThem) {
    RIPSTOP_TOO_LONG_SANITIZED();
    const std::string python = testing::python_with("ezdxf");
    if (python.empty()) GTEST_SKIP() << "no Python with ezdxf here";
    const testing::ScratchDirectory scratch;
    constexpr int count = 150;
    const auto made = testing::run_command(python + " " RIPSTOP_SOURCE_DIR "/tests/dxf/generate.py " + scratch.path() +
                                           " " + std::to_string(count));
    ASSERT_EQ(made.code, 0) << made.output;
    std::istringstream in(made.output);
    PatternDrawing drawing;
    int number = 0, known = -1, drawings = 0;
    std::size_t paths = 0, texts = 0;
    const auto expect_no_more = [&] {
        EXPECT_EQ(paths, drawing.paths.size()) << known << ": lines that ezdxf does not show";
        EXPECT_EQ(texts, drawing.texts.size()) << known << ": texts that ezdxf does not show";
        paths = texts = 0;
    };
    for (std::string row, kind; std::getline(in, row) && !::testing::Test::HasFatalFailure();) {
        std::istringstream words(row);
        words >> number >> kind;
        if (number != known) {
            expect_no_more();
            std::ifstream file(scratch.path(std::to_string(number) + ".dxf"), std::ios::binary);
            drawing = read_dxf(file, std::to_string(number) + ".dxf");
            known = number;
            ++drawings;
        }
        if (kind == "unit") {
            double metres = 0;
            words >> metres;
            EXPECT_EQ(drawing.units.empty() ? 0 : drawing.units.front().unit.metres, metres) << number;
        } else if (kind == "line") {
            const std::string where = std::to_string(number) + ", line " + std::to_string(paths);
            ASSERT_LT(paths, drawing.paths.size()) << where;
            const DrawnPath& path = drawing.paths[paths++];
            expect_line(path, words, where + ", " + path.entity);
        } else {
            const std::string where = std::to_string(number) + ", text " + std::to_string(texts);
            ASSERT_LT(texts, drawing.texts.size()) << where;
            expect_text(drawing.texts[texts++], words, where);
        }
    }
    expect_no_more();
    EXPECT_EQ(drawings, count);
    std::ifstream binary(scratch.path("binary.dxf"), std::ios::binary);
    EXPECT_THROW(read_dxf(binary, "binary.dxf"), InputError);
}

}  // namespace dxf_of_others_test
}  // namespace ripstop
