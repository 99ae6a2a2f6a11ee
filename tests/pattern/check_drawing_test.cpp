#include "ripstop/pattern/check_drawing.h"

#include <gmock/gmock.h>

#include <cmath>

namespace ripstop {
namespace {

using ::testing::HasSubstr;

Points2 points(std::initializer_list<Vec2> list) {
    Points2 all(static_cast<Eigen::Index>(list.size()), 2);
    Eigen::Index i = 0;
    for (const Vec2& p : list) all.row(i++) = p.transpose();
    return all;
}

Points2 square(const Vec2& lower, double side) {
    return points({lower, lower + Vec2(side, 0), lower + Vec2(side, side), lower + Vec2(0, side)});
}

/// In millimetres, and saying so.
PatternDrawing drawing_of(const std::vector<DrawnPath>& paths) {
    PatternDrawing drawing;
    drawing.format = "DXF";
    drawing.units = {{"$INSUNITS", {"mm", 1e-3}}};
    drawing.paths = paths;
    return drawing;
}

DrawnPath closed(const std::string& layer, const Points2& at, int group = -1) {
    return {layer, group, at, true};
}
DrawnPath open(const std::string& layer, const Points2& at, int group = -1) {
    return {layer, group, at, false};
}

std::vector<std::string> codes(const DrawingCheck& check) {
    std::vector<std::string> found;
    for (const DrawingIssue& issue : check.issues) found.push_back(issue.code);
    return found;
}

std::string message(const DrawingCheck& check, const std::string& code) {
    for (const DrawingIssue& issue : check.issues)
        if (issue.code == code) return issue.message;
    return "none";
}

/// A piece in a block: boundary and name.
PatternDrawing block_drawing() {
    PatternDrawing drawing = drawing_of({closed("1", square({0, 0}, 300), 0)});
    drawing.groups = {{"A_ONE", "1"}};
    drawing.texts = {{"1", 0, "Piece Name: A", Vec2(10, 10), 0.25, 0}};
    return drawing;
}

TEST(CheckDrawing, FindsASoundDrawingSound) {
    const DrawingCheck check = check_drawing(drawing_of({closed("CUT", square({10, 20}, 300))}));
    EXPECT_TRUE(check.sound());
    ASSERT_EQ(check.contours.size(), 1U);
    EXPECT_DOUBLE_EQ(check.contours[0].area, 0.09);
    EXPECT_DOUBLE_EQ(check.contours[0].perimeter, 1.2);
    EXPECT_EQ(check.unit_from, "$INSUNITS");
    EXPECT_TRUE(check_drawing(block_drawing()).sound());
}

TEST(CheckDrawing, TakesEdgesThatTouchWithinAHundredthForAClosedContour) {
    const Vec2 a(0, 0), b(300, 0), c(300, 200), d(0, 200), off(0.005, 0.005);
    // One of them the other way round, and none in order.
    const DrawingCheck check =
        check_drawing(drawing_of({open("CUT", points({a, b})), open("CUT", points({d + off, c})),
                                  open("CUT", points({b, c + off})), open("CUT", points({d, a}))}));
    EXPECT_TRUE(check.sound());
    ASSERT_EQ(check.contours.size(), 1U);
    EXPECT_EQ(check.contours[0].parts, 4);
    // The corners taken are up to 0.007 mm off.
    EXPECT_NEAR(check.contours[0].area, 0.06, 5e-6);
}

TEST(CheckDrawing, NamesAGapWithItsPlaceAndWidth) {
    const DrawingCheck check =
        check_drawing(drawing_of({open("CUT", points({{0, 0}, {300, 0}, {300, 200}, {0, 200}, {0, 0.35}}))}));
    EXPECT_EQ(codes(check), (std::vector<std::string>{"gap", "no_contour"}));
    EXPECT_THAT(message(check, "gap"), HasSubstr("open by 0.350 mm between (0.00, 0.35) mm and (0.00, 0.00) mm"));
    EXPECT_NEAR(check.issues[0].at->y(), 0.00035, 1e-12);
}

TEST(CheckDrawing, NamesALineThatIsNoContour) {
    const DrawingCheck check =
        check_drawing(drawing_of({closed("CUT", square({0, 0}, 300)), open("CUT", points({{500, 0}, {600, 0}}))}));
    EXPECT_EQ(codes(check), (std::vector<std::string>{"open"}));
    EXPECT_THAT(message(check, "open"), HasSubstr("a line of 100.0 mm on layer CUT"));
}

TEST(CheckDrawing, TakesASlitFromTheContourForANotch) {
    EXPECT_TRUE(
        check_drawing(drawing_of({closed("CUT", square({0, 0}, 300)), open("CUT", points({{150, 0}, {150, 6}}))}))
            .sound());
}

TEST(CheckDrawing, NamesWhatIsDrawnTwice) {
    const DrawingCheck check = check_drawing(drawing_of(
        {closed("CUT", square({0, 0}, 300)), closed("CUT", square({0, 0}, 300)), closed("SEW", square({0, 0}, 300)),
         open("NOTCH", points({{0, 0}, {6, 0}})), open("NOTCH", points({{6, 0}, {0, 0}}))}));
    EXPECT_EQ(codes(check), (std::vector<std::string>{"duplicate", "duplicate"}));
    EXPECT_THAT(message(check, "duplicate"), HasSubstr("layer CUT: a line is drawn twice"));
    EXPECT_EQ(check.contours.size(), 2U);
}

TEST(CheckDrawing, DoesNotTakeTwoDiagonalsForOne) {
    EXPECT_TRUE(
        check_drawing(drawing_of({closed("CUT", square({0, 0}, 300)), open("INTERNAL", points({{10, 10}, {20, 20}})),
                                  open("INTERNAL", points({{10, 20}, {20, 10}}))}))
            .sound());
}

TEST(CheckDrawing, NamesAContourThatCrossesItself) {
    const DrawingCheck check =
        check_drawing(drawing_of({closed("CUT", points({{0, 0}, {300, 300}, {300, 0}, {0, 300}}))}));
    EXPECT_EQ(codes(check), (std::vector<std::string>{"crossing"}));
    EXPECT_THAT(message(check, "crossing"), HasSubstr("at (150.00, 150.00) mm"));
}

TEST(CheckDrawing, NamesLinesWithoutLength) {
    const DrawingCheck check =
        check_drawing(drawing_of({closed("CUT", square({0, 0}, 300)), open("NOTCH", points({{5, 5}, {5, 5}}))}));
    EXPECT_EQ(codes(check), (std::vector<std::string>{"zero_length"}));
    EXPECT_THAT(message(check, "zero_length"),
                HasSubstr("layer NOTCH: a line without length, the first at (5.00, 5.00)"));
}

TEST(CheckDrawing, AsksForAUnitAndForOneOnly) {
    PatternDrawing drawing = drawing_of({closed("CUT", square({0, 0}, 300))});
    drawing.units.clear();
    EXPECT_EQ(codes(check_drawing(drawing)), (std::vector<std::string>{"unit"}));
    EXPECT_TRUE(check_drawing(drawing, {LengthUnit{"cm", 0.01}, {}}).sound());
    EXPECT_DOUBLE_EQ(check_drawing(drawing, {LengthUnit{"cm", 0.01}, {}}).contours[0].perimeter, 12);
    drawing.units = {{"$MEASUREMENT", {"in", 0.0254}}, {"$INSUNITS", {"mm", 1e-3}}};
    EXPECT_TRUE(check_drawing(drawing).sound()) << "$MEASUREMENT is for hatches";
    drawing.units = {{"$INSUNITS", {"in", 0.0254}}, {"the text \"Units: METRIC\"", {"mm", 1e-3}}};
    EXPECT_EQ(codes(check_drawing(drawing)), (std::vector<std::string>{"unit_conflict"}));
}

TEST(CheckDrawing, MeasuresTheReferenceSquare) {
    PatternDrawing drawing = drawing_of({closed("CUT", square({0, 0}, 300)), closed("REF", square({400, 0}, 100))});
    drawing.texts = {{"REF", -1, "100 mm", Vec2(450, 50), 10, 0}};
    DrawingCheck check = check_drawing(drawing);
    EXPECT_TRUE(check.sound());
    EXPECT_DOUBLE_EQ(check.square.value_or(0), 0.1);
    EXPECT_EQ(check.contours.size(), 1U);
    // As 72 for 96 dots an inch makes it.
    drawing.paths[1].points *= 0.75;
    drawing.texts[0].at *= 0.75;
    check = check_drawing(drawing);
    EXPECT_EQ(codes(check), (std::vector<std::string>{"square"}));
    EXPECT_THAT(message(check, "square"), HasSubstr("measures 75.000 mm: everything is 0.75 times its size"));
}

TEST(CheckDrawing, DoubtsTheUnitOfPiecesThatNobodySews) {
    EXPECT_EQ(codes(check_drawing(drawing_of({closed("CUT", square({0, 0}, 0.3))}))),
              (std::vector<std::string>{"size"}));
    EXPECT_EQ(codes(check_drawing(drawing_of({closed("CUT", square({0, 0}, 300000))}))),
              (std::vector<std::string>{"size"}));
    EXPECT_TRUE(
        check_drawing(drawing_of({closed("CUT", points({{0, 0}, {40000, 0}, {40000, 1400}, {0, 1400}}))})).sound());
}

TEST(CheckDrawing, MeasuresAcrossTheGrainForTheRoll) {
    const DrawnPath piece = closed("CUT", points({{0, 0}, {4000, 0}, {4000, 1400}, {0, 1400}}));
    const DrawingCheckOptions roll{{}, 1.5};
    EXPECT_TRUE(check_drawing(drawing_of({piece}), roll).sound()) << "it may lie either way";
    EXPECT_TRUE(check_drawing(drawing_of({piece, open("GRAIN", points({{1000, 700}, {2000, 700}}))}), roll).sound());
    const DrawingCheck check =
        check_drawing(drawing_of({piece, open("GRAIN", points({{2000, 400}, {2000, 900}}))}), roll);
    EXPECT_EQ(codes(check), (std::vector<std::string>{"roll"}));
    EXPECT_THAT(message(check, "roll"), HasSubstr("4000.0 mm across the grain do not fit on a roll of 1500.0 mm"));
}

TEST(CheckDrawing, ExpectsEachBlockToBeAPiece) {
    PatternDrawing drawing = block_drawing();
    drawing.groups.push_back({"EMPTY", "1"});
    drawing.groups.push_back({"NEVER", "0", 0});
    drawing.paths.push_back(closed("1", square({500, 0}, 100)));
    const DrawingCheck check = check_drawing(drawing);
    EXPECT_EQ(codes(check), (std::vector<std::string>{"block", "block", "block"}));
    EXPECT_THAT(check.issues[0].message, HasSubstr("block EMPTY has 0 closed boundaries"));
    EXPECT_THAT(check.issues[1].message, HasSubstr("block NEVER is never inserted"));
    EXPECT_THAT(check.issues[2].message, HasSubstr("outside of any block"));
}

TEST(CheckDrawing, NamesALayerThatNumberedReadersDrop) {
    PatternDrawing drawing = block_drawing();
    drawing.paths.push_back(open("0", points({{10, 10}, {20, 10}}), 0));
    EXPECT_EQ(codes(check_drawing(drawing)), (std::vector<std::string>{"layer"}));
}

TEST(CheckDrawing, NotesATextThatLiesOnNoPiece) {
    PatternDrawing drawing = block_drawing();
    drawing.texts.push_back({"15", 0, "inside", Vec2(150, 150), 10, 0});
    drawing.texts.push_back({"15", 0, "lost", Vec2(450, 150), 10, 0});
    const DrawingCheck check = check_drawing(drawing);
    EXPECT_TRUE(check.sound());
    EXPECT_THAT(message(check, "text_outside"), HasSubstr("\"lost\" at (450.00, 150.00) mm"));
}

TEST(CheckDrawing, IsNotSureOfCurvesItCannotRead) {
    PatternDrawing drawing = block_drawing();
    drawing.leave_unread("HATCH", "8", 3);
    EXPECT_TRUE(check_drawing(drawing).sound());
    drawing.leave_unread("SPLINE", "1", 7);
    const DrawingCheck check = check_drawing(drawing);
    EXPECT_FALSE(check.sound());
    EXPECT_THAT(check.issues.back().message, HasSubstr("line 7: 1 SPLINE on layer 1 cannot be checked"));
}

TEST(CheckDrawing, CountsEveryClosedLineWhereTheLayersAreNotKnown) {
    const DrawingCheck check =
        check_drawing(drawing_of({closed("Layer 1", square({0, 0}, 300)), open("Layer 1", points({{10, 10}, {50, 10}})),
                                  open("Layer 2", points({{0, 500}, {300, 500}, {300, 700}, {0, 500.4}}))}));
    EXPECT_EQ(check.contours.size(), 1U);
    EXPECT_EQ(codes(check), (std::vector<std::string>{"gap"})) << "a short line may be anything, a near miss is one";
    EXPECT_EQ(codes(check_drawing(drawing_of({}))), (std::vector<std::string>{"no_contour"}));
}

}  // namespace
}  // namespace ripstop
