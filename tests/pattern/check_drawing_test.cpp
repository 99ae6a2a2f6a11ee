#include "ripstop/pattern/drawing/check_drawing.h"

#include <gmock/gmock.h>

#include <cmath>

#include "support/openings.h"

namespace ripstop {
namespace check_drawing_test {

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

/// A drawing in millimetres, which it states.
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
    // One of them is reversed, and they are out of order.
    const DrawingCheck check =
        check_drawing(drawing_of({open("CUT", points({a, b})), open("CUT", points({d + off, c})),
                                  open("CUT", points({b, c + off})), open("CUT", points({d, a}))}));
    EXPECT_TRUE(check.sound());
    ASSERT_EQ(check.contours.size(), 1U);
    EXPECT_EQ(check.contours[0].parts, 4);
    // The corners used are up to 0.007 mm off.
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

TEST(CheckDrawing, NamesAContourWithNothingInIt) {
    const DrawingCheck check =
        check_drawing(drawing_of({closed("CUT", square({0, 0}, 300)), closed("CUT", points({{500, 0}, {900, 0}}))}));
    EXPECT_EQ(codes(check), (std::vector<std::string>{"crossing"}));
    EXPECT_THAT(message(check, "crossing"), HasSubstr("runs from (500.00, 0.00) mm and back"));
}

TEST(CheckDrawing, NamesPiecesThatOverlapAndByHowMuch) {
    PatternDrawing drawing = drawing_of({closed("CUT", square({0, 0}, 300)), closed("CUT", square({290, 250}, 300))});
    drawing.texts = {{"TEXT", -1, "A", Vec2(10, 10), 5, 0}, {"TEXT", -1, "B", Vec2(500, 500), 5, 0}};
    DrawingCheck check = check_drawing(drawing);
    EXPECT_EQ(codes(check), (std::vector<std::string>{"overlap"}));
    EXPECT_THAT(message(check, "overlap"), HasSubstr("A and B overlap by 10.00 mm at (290.00, 250.00) mm"));
    // In a cross, no corner of one lies inside the other.
    drawing.texts.clear();
    drawing.paths = {closed("CUT", points({{0, 100}, {300, 100}, {300, 150}, {0, 150}})),
                     closed("CUT", points({{100, 0}, {200, 0}, {200, 300}, {100, 300}}))};
    check = check_drawing(drawing);
    EXPECT_EQ(codes(check), (std::vector<std::string>{"overlap"}));
    EXPECT_THAT(message(check, "overlap"), HasSubstr("overlap by 50.00 mm"));
}

TEST(CheckDrawing, LetsPiecesHaveACutInCommon) {
    // Two side by side, one of them half as tall, and one around its other sides that overlaps it by 0.05 mm.
    const Points2 round =
        points({{300, 200}, {449.95, 200}, {449.95, 0}, {700, 0}, {700, 700}, {0, 700}, {0, 300}, {300, 300}});
    EXPECT_TRUE(check_drawing(drawing_of({closed("CUT", square({0, 0}, 300)), closed("CUT", square({300, 50}, 150)),
                                          closed("CUT", round)}))
                    .sound());
}

TEST(CheckDrawing, NamesAPieceThatIsDrawnOverItsTwinWithOtherCorners) {
    const DrawingCheck check =
        check_drawing(drawing_of({closed("CUT", square({0, 0}, 300)),
                                  closed("CUT", points({{300.02, 0}, {300, 300}, {150, 300}, {0, 300}, {0, 0}}))}));
    EXPECT_EQ(codes(check), (std::vector<std::string>{"overlap"}));
    EXPECT_THAT(message(check, "overlap"), HasSubstr("lie on each other at (0.00, 0.00) mm"));
}

TEST(CheckDrawing, TellsAHoleFromAPieceByWhatIsDrawnInIt) {
    PatternDrawing drawing = drawing_of({closed("CUT", square({0, 0}, 300)), closed("CUT", square({100, 100}, 80))});
    drawing.texts = {{"TEXT", -1, "A", Vec2(10, 10), 5, 0}};
    EXPECT_TRUE(check_drawing(drawing).sound()) << "a hole";
    drawing.paths.push_back(closed("CUT", square({110, 110}, 50)));
    drawing.texts.push_back({"TEXT", -1, "B", Vec2(120, 120), 5, 0});
    EXPECT_TRUE(check_drawing(drawing).sound()) << "a piece in the hole";
    drawing.paths.pop_back();
    DrawingCheck check = check_drawing(drawing);
    EXPECT_EQ(codes(check), (std::vector<std::string>{"overlap"}));
    EXPECT_THAT(message(check, "overlap"),
                HasSubstr("A and B overlap: the one at (100.00, 100.00) mm is inside the other"));
    drawing.texts.pop_back();
    drawing.paths.push_back(open("GRAIN", points({{110, 110}, {150, 110}})));
    EXPECT_EQ(codes(check_drawing(drawing)), (std::vector<std::string>{"overlap"}));
    drawing.paths.back() = closed("SEW", square({105, 105}, 70));
    EXPECT_EQ(codes(check_drawing(drawing)), (std::vector<std::string>{"overlap"}));
    drawing.paths.back() = closed("SEW", square({95, 95}, 90));
    EXPECT_TRUE(check_drawing(drawing).sound()) << "the seam of a hole";
}

TEST(CheckDrawing, LooksAtEachBlockAlone) {
    PatternDrawing drawing = block_drawing();
    drawing.groups.push_back({"B_ONE", "1"});
    drawing.paths.push_back(closed("1", square({100, 100}, 300), 1));
    EXPECT_TRUE(check_drawing(drawing).sound()) << "Gerber stacks the pieces";
    drawing.paths.push_back(closed("11", square({150, 150}, 20), 1));
    EXPECT_TRUE(check_drawing(drawing).sound()) << "an internal cut";
    drawing.paths.back() = closed("11", square({80, 150}, 40), 1);
    EXPECT_EQ(codes(check_drawing(drawing)), (std::vector<std::string>{"overlap"}));
    drawing.paths.back() = closed("14", square({80, 150}, 40), 1);
    EXPECT_EQ(codes(check_drawing(drawing)), (std::vector<std::string>{"sew_outside"}));
}

TEST(CheckDrawing, NamesASewLineOutsideOfThePieces) {
    const DrawnPath piece = closed("CUT", square({0, 0}, 300));
    EXPECT_TRUE(check_drawing(drawing_of({piece, closed("SEW", square({15, 15}, 270))})).sound());
    EXPECT_TRUE(check_drawing(drawing_of({piece, closed("SEW", square({0, 0}, 300))})).sound()) << "no allowance";
    EXPECT_TRUE(check_drawing(drawing_of({piece, closed("SEW", square({-0.01, -0.01}, 300.02))})).sound()) << "rounded";
    DrawingCheck check = check_drawing(drawing_of({piece, closed("SEW", square({40, 40}, 270))}));
    EXPECT_EQ(codes(check), (std::vector<std::string>{"sew_outside"}));
    // The far corner protrudes by 10 mm in both directions.
    EXPECT_THAT(message(check, "sew_outside"),
                HasSubstr("reaches 14.14 mm out of the one on layer CUT at (310.00, 310.00)"));
    check = check_drawing(drawing_of({piece, closed("SEW", square({-10, -10}, 320))}));
    EXPECT_THAT(message(check, "sew_outside"), HasSubstr("reaches 14.14 mm out of"));
    check = check_drawing(drawing_of({piece, closed("SEW", square({400, 40}, 200))}));
    EXPECT_EQ(codes(check), (std::vector<std::string>{"sew_outside"}));
    EXPECT_THAT(message(check, "sew_outside"),
                HasSubstr("at (400.00, 40.00) mm lies in no closed contour that is cut"));
}

/// A closed path of these lines, in millimetres.
DrawnPath drawn(const char* layer, const Points2& metres) {
    return closed(layer, 1000 * metres);
}

TEST(CheckDrawing, NamesAnOpeningOfTheSewLineThatNothingCuts) {
    const auto cut_of = [](const PatternPiece& piece) {
        Points2 outside(4, 2);
        const Vec2 lower = piece.lower(), upper = piece.upper();
        outside << lower.x(), lower.y(), upper.x(), lower.y(), upper.x(), upper.y(), lower.x(), upper.y();
        return outside;
    };
    for (const double slit : {0.0, 0.01, 0.03, 0.045, 0.06, 0.2})
        for (const bool is_turned : {false, true}) {
            const PatternPiece piece = testing::cut_piece(testing::square_keyhole(slit, 0.25, 0.025));
            const Points2 sew = is_turned ? Points2(piece.sew_line.colwise().reverse()) : piece.sew_line;
            EXPECT_TRUE(check_drawing(drawing_of({drawn("CUT", piece.cut_line), drawn("SEW", sew)})).sound() ||
                        slit == 0)
                << slit;
            const DrawingCheck check = check_drawing(drawing_of({drawn("CUT", cut_of(piece)), drawn("SEW", sew)}));
            if (slit == 0) continue;  // it touches itself, which is reported
            EXPECT_EQ(codes(check), (std::vector<std::string>{"opening"})) << slit;
            EXPECT_THAT(message(check, "opening"), HasSubstr("nothing on layer CUT is cut in between")) << slit;
        }
    const PatternPiece ring = testing::cut_piece(testing::open_ring(6.2, 0.025));
    EXPECT_TRUE(check_drawing(drawing_of({drawn("CUT", ring.cut_line), drawn("SEW", ring.sew_line)})).sound());
    EXPECT_EQ(codes(check_drawing(drawing_of({drawn("CUT", cut_of(ring)), drawn("SEW", ring.sew_line)}))),
              (std::vector<std::string>{"opening"}));
}

TEST(CheckDrawing, TakesCornersThatAllowancesCloseAndHolesThatAreCutForSound) {
    for (const double angle : {1.1, 1.6, 2.5}) {
        const PatternPiece notched = testing::cut_piece(testing::notched_strip(angle, 0.025));
        EXPECT_TRUE(
            check_drawing(drawing_of({drawn("CUT", notched.cut_line), drawn("SEW", notched.sew_line)})).sound());
    }
    // A square hole of the cloth, sewn around and cut. The sew line has a slit to it that is not cut: the seam
    // goes there and back.
    const PatternPiece piece = testing::cut_piece(testing::square_keyhole(0.06, 0.25, 0.025));
    DrawnPath hole = closed("CUT", square({300, 275}, 200)), outside = closed("CUT", square({-25, -25}, 850));
    const DrawingCheck check = check_drawing(drawing_of({outside, hole, drawn("SEW", piece.sew_line)}));
    EXPECT_EQ(codes(check), (std::vector<std::string>{"opening"})) << "the slit";
    const DrawnPath seam = closed("SEW", square({0, 0}, 800)), round = closed("SEW", square({275, 250}, 250));
    EXPECT_TRUE(check_drawing(drawing_of({outside, hole, seam, round})).sound());
}

TEST(CheckDrawing, DoesNotTakeLinesWithinEachOtherForPiecesWhereTheLayersAreNotKnown) {
    const DrawnPath piece = closed("Layer 1", square({0, 0}, 300));
    EXPECT_TRUE(check_drawing(drawing_of({piece, closed("Layer 1", square({15, 15}, 270))})).issues.empty());
    EXPECT_FALSE(check_drawing(drawing_of({piece, closed("Layer 1", square({150, 15}, 270))})).sound());
    const DrawingCheck check = check_drawing(drawing_of({piece, closed("Layer 2", square({150, 15}, 270))}));
    EXPECT_EQ(codes(check), (std::vector<std::string>{"overlap"}));
    EXPECT_TRUE(check.sound()) << "the other one may be no piece";
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
    // As if 72 dots per inch were taken for 96.
    drawing.paths[1].points *= 0.75;
    drawing.texts[0].at *= 0.75;
    check = check_drawing(drawing);
    EXPECT_EQ(codes(check), (std::vector<std::string>{"square"}));
    EXPECT_THAT(message(check, "square"), HasSubstr("measures 75.000 mm: everything is 0.75 times its size"));
}

TEST(CheckDrawing, DoubtsTheUnitOfPiecesThatNobodySews) {
    EXPECT_EQ(codes(check_drawing(drawing_of({closed("CUT", points({{0, 0}, {90000, 0}, {90000, 900}, {0, 900}}))}))),
              (std::vector<std::string>{"size"}));
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
    EXPECT_THAT(message(check, "roll"), HasSubstr("4000.0 mm across the grain, too wide for a roll of 1500.0 mm"));
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
    drawing.leave_unread("SPLINE without control points", "1", 7);
    const DrawingCheck check = check_drawing(drawing);
    EXPECT_FALSE(check.sound());
    EXPECT_THAT(check.issues.back().message,
                HasSubstr("line 7: 1 SPLINE without control points on layer 1 cannot be checked"));
}

TEST(CheckDrawing, TellsAnOutlineLeftOpenFromAMarkWhereTheLayersAreNotKnown) {
    const DrawnPath piece = closed("0", square({0, 0}, 300));
    const auto found = [&piece](const Points2& line) { return check_drawing(drawing_of({piece, open("0", line)})); };
    // A whole side is missing.
    const DrawingCheck side = found(points({{500, 0}, {800, 0}, {800, 300}, {500, 300}}));
    EXPECT_EQ(codes(side), (std::vector<std::string>{"open"}));
    EXPECT_THAT(message(side, "open"), HasSubstr("its ends are 300.0 mm apart"));
    EXPECT_FALSE(found(points({{500, 0}, {800, 0}, {800, 300}, {500, 300}, {500, 20}})).sound());
    // The same line inside a piece may be a pocket; a straight one is a ruler or an arrow.
    for (const Points2& mark : {points({{50, 50}, {100, 50}, {100, 100}, {50, 100}}), points({{400, 0}, {400, 300}})}) {
        const DrawingCheck check = found(mark);
        EXPECT_TRUE(check.sound());
        EXPECT_EQ(codes(check), (std::vector<std::string>{"open_line"}));
        EXPECT_EQ(check.open_lines, 1);
    }
}

TEST(CheckDrawing, MeasuresTheSideThatTwoPiecesShare) {
    const auto shared = [](double x, double y) {
        return message(
            check_drawing(drawing_of({closed("CUT", square({0, 0}, 300)), closed("CUT", square({x, y}, 300))})),
            "common_side");
    };
    EXPECT_THAT(shared(300, 0), HasSubstr("share 300.0 mm of their outlines"));
    EXPECT_THAT(shared(300, 100), HasSubstr("share 200.0 mm of their outlines"));
    EXPECT_EQ(shared(300, 300), "none") << "a corner";
    EXPECT_EQ(shared(300.1, 0), "none") << "as a cutter leaves between them";
}

TEST(CheckDrawing, CountsEveryClosedLineWhereTheLayersAreNotKnown) {
    const DrawingCheck check =
        check_drawing(drawing_of({closed("Layer 1", square({0, 0}, 300)), open("Layer 1", points({{10, 10}, {50, 10}})),
                                  open("Layer 2", points({{0, 500}, {300, 500}, {300, 700}, {0, 500.4}}))}));
    EXPECT_EQ(check.contours.size(), 1U);
    EXPECT_EQ(codes(check), (std::vector<std::string>{"open_line", "gap"}))
        << "a short line may be anything, a near miss is one";
    EXPECT_EQ(codes(check_drawing(drawing_of({}))), (std::vector<std::string>{"no_contour"}));
}

}  // namespace check_drawing_test
}  // namespace ripstop
