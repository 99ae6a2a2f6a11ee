#include "ripstop/io/svg/svg_read.h"

#include <gmock/gmock.h>

#include <numbers>
#include <sstream>

#include "ripstop/base/error.h"
#include "ripstop/geometry/polygon.h"
#include "ripstop/io/svg/svg.h"
#include "ripstop/pattern/drawing/check_drawing.h"
#include "support/dxf_pieces.h"
#include "support/refusal.h"

namespace ripstop {
namespace svg_read_test {

using ::testing::HasSubstr;

PatternDrawing read(const std::string& text) {
    std::istringstream in(text);
    return read_svg(in, "a.svg");
}

PatternDrawing read_body(const std::string& body) {
    return read("<svg width='100mm' viewBox='0 0 100 50'>" + body + "</svg>");
}

std::string refusal(const std::string& text) {
    return testing::refusal([&] { read(text); });
}

TEST(ReadSvg, TakesPathsWithEveryCommandOfStraightLines) {
    const PatternDrawing found = read_body("<path class='cut' d='M10-5l5,0 0 1.5.5e1 0h-2.5V2zm1 1L2 3'/>");
    ASSERT_EQ(found.paths.size(), 2U);
    Points2 expected(6, 2);
    expected << 10, 5, 15, 5, 15, 3.5, 20, 3.5, 17.5, 3.5, 17.5, -2;
    EXPECT_EQ(found.paths[0].points, expected) << "y up";
    EXPECT_TRUE(found.paths[0].is_closed);
    EXPECT_EQ(found.paths[0].layer, "cut");
    EXPECT_EQ(found.paths[1].points, (Points2(2, 2) << 11, 4, 2, -3).finished()) << "m after z is from its start";
}

TEST(ReadSvg, MovesWhatIsTransformedAndKnowsGroupsAndLayers) {
    const PatternDrawing found = read_body(
        "<g inkscape:groupmode='layer' inkscape:label='CUT'><g id='P1' transform='translate(10,20) rotate(90)'>"
        "<rect width='2' height='1' transform='scale(2)'/></g></g>"
        "<g id='ref' transform='matrix(0 1 -1 0 5 0)'><line x1='1' y1='2' x2='3' y2='2'/></g>");
    ASSERT_EQ(found.paths.size(), 2U);
    EXPECT_EQ(found.paths[0].layer, "CUT");
    ASSERT_EQ(found.groups.size(), 2U);
    EXPECT_EQ(found.groups[static_cast<std::size_t>(found.paths[0].group)].name, "P1");
    Points2 expected(4, 2);
    expected << 10, -20, 10, -24, 8, -24, 8, -20;
    EXPECT_LT((found.paths[0].points - expected).norm(), 1e-12);
    EXPECT_LT((found.paths[1].points - (Points2(2, 2) << 3, -1, 3, -3).finished()).norm(), 1e-12);
}

TEST(ReadSvg, SaysItsUnitOnlyWhereItHasOne) {
    EXPECT_EQ(read("<svg width='210mm' viewBox='0 0 210 297'/>").units.at(0).unit.name, "mm");
    EXPECT_EQ(read("<svg width='10in' viewBox='0 0 254 1'/>").units.at(0).unit.name, "mm");
    EXPECT_DOUBLE_EQ(read("<svg width='10in' viewBox='0 0 960 1'/>").units.at(0).unit.metres, 0.0254 / 96);
    EXPECT_DOUBLE_EQ(read("<svg width='10mm'/>").units.at(0).unit.metres, 0.0254 / 96);
    EXPECT_TRUE(read("<svg width='210' viewBox='0 0 210 297'/>").units.empty());
    EXPECT_TRUE(read("<svg width='100%'/>").units.empty());
}

TEST(ReadSvg, LeavesOutWhatIsHidden) {
    const PatternDrawing found = read_body(
        "<g style='fill:none; display: none'><rect width='2' height='1'/></g><rect display='none' width='2' "
        "height='1'/>"
        "<g visibility='hidden'><rect width='2' height='1'/><circle visibility='visible' r='1'/></g>"
        "<style>.x { display: none } #y.z, line { visibility: hidden !important }</style><path class='x' d='M0 0L1 1'/>"
        "<rect id='y' class='a z' style='visibility:visible' width='2' height='1'/><line x2='1'/>");
    ASSERT_EQ(found.paths.size(), 1U);
    EXPECT_EQ(found.paths[0].entity, "circle");
    EXPECT_TRUE(found.unread.empty());
}

TEST(ReadSvg, FitsTheDrawingIntoWidthAndHeightAsSvgDoes) {
    // A user unit is 2 mm by the width and 1 mm by the height: the smaller shows everything, the larger fills the
    // page.
    const PatternDrawing found = read("<svg width='100mm' height='100mm' viewBox='0 0 50 100'/>");
    ASSERT_EQ(found.units.size(), 2U);
    EXPECT_EQ(found.units[0].where, "height and viewBox");
    EXPECT_EQ(found.units[0].unit.name, "mm");
    EXPECT_DOUBLE_EQ(found.units[1].unit.metres, 2e-3);
    EXPECT_FALSE(check_drawing(found).sound()) << "many readers know only the width";
    EXPECT_DOUBLE_EQ(
        read("<svg width='100mm' height='100mm' viewBox='0 0 50 100' preserveAspectRatio='xMidYMid slice'/>")
            .units.at(0)
            .unit.metres,
        2e-3);
    EXPECT_DOUBLE_EQ(read("<svg width='100mm' height='96' viewBox='0 0 100 100'/>").units.at(0).unit.metres, 0.254e-3)
        << "a bare number counts 1/96 inch";
    // Rounding to a hundredth: the smaller unit is taken, without an alternative.
    const PatternDrawing rounded = read("<svg width='210mm' height='297mm' viewBox='0 0 210 297.01'/>");
    ASSERT_EQ(rounded.units.size(), 1U);
    EXPECT_DOUBLE_EQ(rounded.units[0].unit.metres, 0.297 / 297.01);
    EXPECT_EQ(read("<svg height='297mm' viewBox='0 0 210 297'/>").units.at(0).unit.name, "mm");
    EXPECT_EQ(read("<svg width='100%' height='297mm' viewBox='0 0 210 297'/>").units.at(0).unit.name, "mm");
}

TEST(ReadSvg, RefusesWithThePlaceWhatItCannotUse) {
    EXPECT_THAT(refusal("<svg><path"), HasSubstr("a.svg: byte "));
    EXPECT_THAT(refusal("<html/>"), HasSubstr("expected svg"));
    EXPECT_THAT(refusal("<svg width='1e28cm' viewBox='0 0 1 1'/>"), HasSubstr("expected less than 10 m"));
    EXPECT_THAT(refusal("<svg><path d='L1 1'/></svg>"), HasSubstr("expected M at its start"));
    EXPECT_THAT(refusal("<svg><path d='M1 x'/></svg>"), HasSubstr("expected a number"));
    EXPECT_THAT(refusal("<svg><path d='M1 1e99'/></svg>"), HasSubstr("within 1e9"));
    EXPECT_THAT(refusal("<svg><g transform='turn(3)'/></svg>"), HasSubstr("expected one of SVG"));
    std::string deep = "<svg>";
    for (int i = 0; i < 300; ++i) deep += "<g>";
    for (int i = 0; i < 300; ++i) deep += "</g>";
    EXPECT_THAT(refusal(deep + "</svg>"), HasSubstr("256 deep"));
}

TEST(ReadSvg, FindsEveryPieceOfOurOwnWhereItWas) {
    const std::vector<PatternPiece> pieces = testing::sample_pieces();
    std::stringstream svg;
    write_svg(svg, pieces);
    const DrawingCheck check = check_drawing(read_svg(svg, "a.svg"));
    EXPECT_TRUE(check.sound()) << check.issues.front().message;
    ASSERT_TRUE(check.square.has_value());
    EXPECT_NEAR(*check.square, 0.1, 1e-9);
    std::size_t cut = 0;
    for (const DrawingContour& contour : check.contours) {
        if (!contour.is_cut) continue;
        const PatternPiece& piece = pieces.at(cut++);
        EXPECT_EQ(contour.piece, piece.name);
        // Three decimals: each coordinate has an error of up to 0.5 um.
        EXPECT_NEAR(contour.area, signed_area(piece.cut_line), 1e-6 * contour.perimeter);
        EXPECT_NEAR(contour.perimeter, perimeter(piece.cut_line), 1e-5);
    }
    EXPECT_EQ(cut, pieces.size());
}

}  // namespace svg_read_test
}  // namespace ripstop
