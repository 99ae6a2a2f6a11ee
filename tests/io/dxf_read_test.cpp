#include "ripstop/io/dxf/dxf_read.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>
#include <sstream>

#include "ripstop/base/error.h"
#include "ripstop/pattern/drawing/check_drawing.h"
#include "support/outside.h"
#include "support/refusal.h"

namespace ripstop {
namespace dxf_read_test {

using ::testing::HasSubstr;

/// Expands `0 LINE 8 A` to DXF: group codes and values in turn; an underscore stands for a blank.
std::string groups(const std::string& words) {
    std::istringstream in(words);
    std::string text, code, value;
    while (in >> code >> value) {
        for (char& c : value)
            if (c == '_') c = ' ';
        text += code + "\n" + value + "\n";
    }
    return text;
}

std::string drawing(const std::string& entities, const std::string& before = "") {
    return groups(before + " 0 SECTION 2 ENTITIES " + entities + " 0 ENDSEC 0 EOF");
}

PatternDrawing read(const std::string& text) {
    std::istringstream in(text);
    return read_dxf(in, "a.dxf");
}

std::string refusal(const std::string& text) {
    return testing::refusal([&] { read(text); });
}

double length(const DrawnPath& path) {
    double sum = 0;
    const Eigen::Index count = path.points.rows();
    for (Eigen::Index i = path.is_closed ? 0 : 1; i < count; ++i)
        sum += (path.points.row(i) - path.points.row((i + count - 1) % count)).norm();
    return sum;
}

// One point per degree: too short by angle^2 / 24 = 1.3e-5 of the length.
constexpr double sampled = 2e-5;

TEST(ReadDxf, TakesLinesPolylinesAndPointsOfAllReleases) {
    const PatternDrawing found =
        read(drawing("0 LINE 8 A 10 1 20 2 11 4 21 6 "
                     "0 POLYLINE 8 CUT 66 1 70 1 0 VERTEX 8 CUT 10 0 20 0 0 VERTEX 8 CUT 10 2 20 0 0 VERTEX 8 CUT 10 2 "
                     "20 1 0 SEQEND "
                     "0 LWPOLYLINE 8 7 90 2 70 0 10 5 20 5 10 6 20 5 "
                     "0 POINT 8 4 10 1 20 1 30 -4 39 3 50 90 "
                     "0 TEXT 8 1 10 3 20 4 40 0.25 1 Piece_Name:_X "));
    ASSERT_EQ(found.paths.size(), 3U);
    EXPECT_EQ(length(found.paths[0]), 5);
    EXPECT_EQ(found.paths[0].line, 5);
    EXPECT_TRUE(found.paths[1].is_closed);
    EXPECT_EQ(found.paths[1].layer, "CUT");
    EXPECT_DOUBLE_EQ(length(found.paths[1]), 3 + std::sqrt(5));
    EXPECT_FALSE(found.paths[2].is_closed);
    ASSERT_EQ(found.points.size(), 1U);
    EXPECT_EQ(found.points[0].height, -4);
    EXPECT_EQ(found.points[0].width, 3);
    EXPECT_EQ(found.points[0].angle, 90);
    ASSERT_EQ(found.texts.size(), 1U);
    EXPECT_EQ(found.texts[0].text, "Piece Name: X");
}

TEST(ReadDxf, SamplesArcsCirclesAndBulges) {
    const PatternDrawing found =
        read(drawing("0 CIRCLE 8 A 10 1 20 2 40 3 0 ARC 8 A 10 0 20 0 40 2 50 350 51 20 "
                     "0 LWPOLYLINE 8 A 70 1 10 0 20 0 42 1 10 2 20 0 42 1 "
                     "0 LWPOLYLINE 8 A 70 0 10 0 20 0 42 0.41421356237309503 10 1 20 1 "));
    ASSERT_EQ(found.paths.size(), 4U);
    constexpr double pi = std::numbers::pi;
    EXPECT_NEAR(length(found.paths[0]), 6 * pi, 6 * pi * sampled);
    EXPECT_NEAR(length(found.paths[1]), 2 * pi / 6, sampled);
    EXPECT_NEAR(length(found.paths[2]), 2 * pi, 2 * pi * sampled) << "two half circles of diameter 2";
    EXPECT_NEAR(length(found.paths[3]), pi / 2, sampled) << "a quarter of the unit circle";
    // Counter-clockwise, so it bulges to the right of the chord.
    EXPECT_NEAR(found.paths[3].points.row(45).x(), std::sin(pi / 4), 1e-9);
    EXPECT_NEAR(found.paths[3].points.row(45).y(), 1 - std::cos(pi / 4), 1e-9);
}

TEST(ReadDxf, PutsBlocksInBlocksWhereTheyAreInserted) {
    const std::string blocks =
        "0 SECTION 2 BLOCKS 0 BLOCK 8 0 2 IN 70 0 10 1 20 0 0 LINE 8 A 10 1 20 0 11 2 21 0 0 ENDBLK "
        "0 BLOCK 8 0 2 OUT 10 0 20 0 0 INSERT 8 A 2 IN 10 10 20 0 41 2 50 90 0 ENDBLK "
        "0 BLOCK 8 0 2 UNUSED 10 0 20 0 0 ENDBLK 0 BLOCK 8 0 2 *Model_Space 10 0 20 0 0 ENDBLK 0 ENDSEC";
    const PatternDrawing found =
        read(drawing("0 INSERT 8 1 2 OUT 10 0 20 5 0 INSERT 8 1 2 IN 10 0 20 0 70 2 44 7", blocks));
    ASSERT_EQ(found.paths.size(), 3U);
    // Scaled by two, turned upright, moved by (10, 0), then by (0, 5).
    EXPECT_LT((found.paths[0].points - (Points2(2, 2) << 10, 5, 10, 7).finished()).norm(), 1e-12);
    EXPECT_LT((found.paths[2].points - (Points2(2, 2) << 7, 0, 8, 0).finished()).norm(), 1e-12) << "second column";
    ASSERT_EQ(found.groups.size(), 4U);
    EXPECT_EQ(found.groups[0].name, "OUT");
    EXPECT_EQ(found.groups[3].name, "UNUSED");
    EXPECT_EQ(found.groups[3].insertions, 0);
    EXPECT_EQ(found.paths[0].group, 0);
    EXPECT_EQ(found.paths[2].group, 2);
}

TEST(ReadDxf, TurnsOverWhatIsSeenFromBelow) {
    const PatternDrawing found =
        read(drawing("0 LWPOLYLINE 8 A 70 0 230 -1 10 1 20 0 10 2 20 0 0 LINE 8 A 230 -1 10 1 20 0 11 2 21 0"));
    EXPECT_EQ(found.paths[0].points(1, 0), -2);
    EXPECT_EQ(found.paths[1].points(1, 0), 2) << "a LINE is in space";
}

TEST(ReadDxf, SaysWhereTheUnitIsStated) {
    const PatternDrawing found = read(drawing("0 TEXT 8 1 10 0 20 0 40 1 1 UNITS:_ENGLISH",
                                              "999 a_comment 0 SECTION 2 HEADER 9 $ACADVER 1 AC1015 9 $INSUNITS 70 4 "
                                              "9 $MEASUREMENT 70 1 0 ENDSEC"));
    EXPECT_EQ(found.format, "DXF AC1015");
    EXPECT_EQ(found.comment, "a comment");
    ASSERT_EQ(found.units.size(), 2U) << "$MEASUREMENT is for hatches";
    EXPECT_EQ(found.units[0].unit.name, "mm");
    EXPECT_EQ(found.units[1].unit.name, "in");
    EXPECT_EQ(found.units[1].where, "the text \"UNITS: ENGLISH\"");
}

TEST(ReadDxf, DoesNotTakeMetricForMillimetres) {
    const std::string square = "0 LWPOLYLINE 8 CUT 70 1 10 0 20 0 10 300 20 0 10 300 20 300 10 0 20 300";
    const DrawingCheck check =
        check_drawing(read(drawing(square, "0 SECTION 2 HEADER 9 $MEASUREMENT 70 1 9 $INSUNITS 70 0 0 ENDSEC")));
    EXPECT_FALSE(check.unit.has_value());
    ASSERT_EQ(check.issues.size(), 1U);
    EXPECT_EQ(check.issues[0].code, "unit");
}

TEST(ReadDxf, NamesWhatItDoesNotRead) {
    const PatternDrawing found =
        read(drawing("0 SPLINE 8 CUT 0 SPLINE 8 CUT 0 HATCH 8 A 0 LINE 67 1 8 A 10 0 20 0 11 1 21 1"));
    ASSERT_EQ(found.unread.size(), 2U);
    EXPECT_EQ(found.unread[0].kind, "SPLINE without control points");
    EXPECT_EQ(found.unread[0].count, 2);
    EXPECT_TRUE(found.paths.empty()) << "the line is on paper";
}

TEST(ReadDxf, RefusesWithTheLineWhatItCannotUse) {
    EXPECT_THAT(refusal("hello\nworld\n"), HasSubstr("a.dxf:1: \"hello\" in place of a group code"));
    EXPECT_THAT(refusal("AutoCAD Binary DXF\r\n\x1a"), HasSubstr("a binary DXF"));
    EXPECT_THAT(refusal("AC1015 something"), HasSubstr("a DWG"));
    EXPECT_THAT(refusal(groups("0 SECTION 2 ENTITIES 0 LINE")), HasSubstr("ends without EOF"));
    EXPECT_THAT(refusal(groups("0 SECTION 2 ENTITIES 0 EOF")), HasSubstr("a section without ENDSEC"));
    EXPECT_THAT(refusal(groups("0 EOF")), HasSubstr("no section ENTITIES"));
    EXPECT_THAT(refusal(drawing("0 LINE 8 A 10 x 20 0")), HasSubstr("a.dxf:10: \"x\" in a LINE, expected a number"));
    EXPECT_THAT(refusal(drawing("0 LINE 8 A 10 1e300 20 0")), HasSubstr("within 1e9"));
    EXPECT_THAT(refusal(drawing("0 INSERT 8 A 2 NONE 10 0 20 0")), HasSubstr("expected a block of the file"));
    EXPECT_THAT(refusal(drawing("0 INSERT 8 A 2 B", "0 SECTION 2 BLOCKS 0 BLOCK 2 B 0 INSERT 2 B 0 ENDBLK 0 ENDSEC")),
                HasSubstr("a block contains itself"));
    EXPECT_THAT(refusal(drawing("0 INSERT 8 A 2 B 70 30000 71 30000 44 1 45 1",
                                "0 SECTION 2 BLOCKS 0 BLOCK 2 B 0 ENDBLK 0 ENDSEC")),
                HasSubstr("points; explode them"));
}

TEST(ReadDxf, AlwaysNamesTheFileAtWhateverByteItIsCut) {
    const std::string whole =
        drawing("0 INSERT 8 1 2 B 0 TEXT 8 1 1 Units:_METRIC",
                "0 SECTION 2 BLOCKS 0 BLOCK 2 B 0 LWPOLYLINE 70 1 10 0 20 0 42 1 10 1 20 0 0 ENDBLK 0 ENDSEC");
    ASSERT_EQ(refusal(whole), "accepted");
    for (std::size_t size = 0; size + 2 < whole.size(); ++size)
        EXPECT_THAT(refusal(whole.substr(0, size)), ::testing::StartsWith("a.dxf:")) << size;
}

}  // namespace dxf_read_test
}  // namespace ripstop
