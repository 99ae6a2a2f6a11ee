#include "ripstop/pipeline/drawing/lift_drawing.h"

#include <gmock/gmock.h>

#include <cmath>
#include <sstream>

#include "ripstop/base/error.h"
#include "ripstop/base/text/units.h"
#include "ripstop/io/dxf/dxf.h"
#include "ripstop/io/dxf/dxf_read.h"
#include "ripstop/io/svg/svg.h"
#include "ripstop/io/svg/svg_read.h"
#include "ripstop/plan_folder/cut_files.h"
#include "support/flat_tiles.h"

namespace ripstop {
namespace lift_drawing_test {

using ::testing::HasSubstr;

/// Two sheets of the same size that are bent without stretch, and a stripe on the second.
struct Plan {
    std::vector<FlatTile> tiles{testing::flat_cylinder("left"), testing::flat_cylinder("right")};
    PieceSet set;
    Vec2 from, to;

    Plan() {
        for (const FlatTile& tile : tiles) set.pieces.push_back(testing::piece_of(tile));
        const Points2& flat = tiles[1].flattening.positions;
        const Vec2 lower = flat.colwise().minCoeff(), upper = flat.colwise().maxCoeff();
        from = lower + 0.3 * (upper - lower);
        to = lower + Vec2(0.9, 0.6).cwiseProduct(upper - lower);
    }
    void draw_stripe() {
        DrawnLine stripe{"stripe", Points2(2, 2)};
        stripe.points.row(0) = from;
        stripe.points.row(1) = to;
        set.pieces[1].lines.push_back(stripe);
    }
    LiftedLines lift(const PatternDrawing& drawing, const std::string& stem = "") const {
        const auto tile_of = [this](const PatternPiece& piece) {
            const FlatTile& tile = piece.name == "left" ? tiles[0] : tiles[1];
            return NamedMesh{piece.name, tile.tile.mesh, tile.flattening.positions};
        };
        return lift_drawing(drawing, millimetre, set, tile_of, stem);
    }
};

/// `format`: svg or a dialect of DXF.
PatternDrawing drawn_as(const std::string& format, const Plan& plan, std::vector<PatternPiece> pieces = {}) {
    std::stringstream file;
    if (pieces.empty()) pieces = plan.set.pieces;
    const std::vector<Vec2> shifts = lay_out(pieces, 0.1);
    if (format != "svg") {
        DxfOptions options;
        options.dialect = format;
        write_dxf(file, pieces, shifts, options);
        return read_dxf(file, "sheet.dxf");
    }
    write_svg(file, pieces, shifts);
    return read_svg(file, "sheet.svg");
}

PatternDrawing without_names(PatternDrawing drawing) {
    drawing.texts.clear();
    for (DrawingGroup& group : drawing.groups) group.name = "group";
    return drawing;
}

class LiftDrawing : public ::testing::TestWithParam<std::string> {};

TEST_P(LiftDrawing, BringsALineDrawnOnASheetBackOntoItsOwnTile) {
    Plan plan;
    plan.draw_stripe();
    const LiftedLines lifted = plan.lift(drawn_as(GetParam(), plan));
    EXPECT_EQ(lifted.pieces, 2);
    ASSERT_EQ(lifted.curves.size(), 1U) << "what the pieces bring themselves is no line";
    const NamedCurve& curve = lifted.curves[0];
    EXPECT_EQ(curve.attributes.at("tile"), "right") << "equal pieces in their order";
    const Eigen::Index n = curve.points.rows() - 1;
    const double length = (curve.points.bottomRows(n) - curve.points.topRows(n)).rowwise().norm().sum();
    EXPECT_NEAR(length, (plan.to - plan.from).norm(), 1e-6) << "files have four decimals of a millimetre";
    for (Eigen::Index i = 0; i <= n; ++i)
        EXPECT_NEAR(std::hypot(curve.points(i, 0), curve.points(i, 1)), 1, 0.01) << "on the cylinder";
}

TEST_P(LiftDrawing, FindsNothingOnPatternsWithoutDrawing) {
    const Plan plan;
    const LiftedLines lifted = plan.lift(drawn_as(GetParam(), plan));
    EXPECT_EQ(lifted.pieces, 2);
    EXPECT_TRUE(lifted.curves.empty());
}

TEST_P(LiftDrawing, FindsNoPieceThatIsAnotherSize) {
    Plan plan;
    plan.draw_stripe();
    const PatternDrawing drawing = drawn_as(GetParam(), plan);
    for (PatternPiece& piece : plan.set.pieces) piece.cut_line *= 1.001;
    const LiftedLines lifted = plan.lift(drawing);
    EXPECT_EQ(lifted.pieces, 0);
    EXPECT_EQ(lifted.strangers, (std::vector<std::string>{"left", "right"}));
    EXPECT_TRUE(lifted.curves.empty());
}

TEST_P(LiftDrawing, TakesThePieceWhoseNameIsThereThoughAnotherIsEqual) {
    Plan plan;
    plan.draw_stripe();
    const LiftedLines lifted = plan.lift(drawn_as(GetParam(), plan, {plan.set.pieces[1]}));
    EXPECT_EQ(lifted.pieces, 1);
    ASSERT_EQ(lifted.curves.size(), 1U);
    EXPECT_EQ(lifted.curves[0].attributes.at("tile"), "right");
}

TEST_P(LiftDrawing, WantsToKnowWhichOfEqualPiecesItIs) {
    Plan plan;
    plan.draw_stripe();
    plan.set.pieces[0].file = "left";
    plan.set.pieces[1].file = "right_file";
    const PatternDrawing drawing = without_names(drawn_as(GetParam(), plan, {plan.set.pieces[1]}));
    try {
        plan.lift(drawing);
        FAIL() << "accepted";
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("fits several pieces: left, right"));
    }
    const LiftedLines lifted = plan.lift(drawing, "right_file");
    ASSERT_EQ(lifted.curves.size(), 1U);
    EXPECT_EQ(lifted.curves[0].attributes.at("tile"), "right");
}

TEST_P(LiftDrawing, TellsAPieceFromItsMirrorImageByThePointsOfTheOutline) {
    Points2 corners(4, 2), turned_over(4, 2);
    corners << 0, 0, 1, 0, 0.7, 0.4, 0, 0.4;
    turned_over << 0, 0, 0.7, 0, 1, 0.4, 0, 0.4;
    Plan plan;
    plan.tiles = {testing::flat_polygon("left", corners), testing::flat_polygon("right", turned_over)};
    plan.set.pieces = {testing::piece_of(plan.tiles[0]), testing::piece_of(plan.tiles[1])};
    Points2 line(2, 2);
    line << 0.2, 0.1, 0.5, 0.3;
    plan.set.pieces[1].lines.push_back({"stripe", line});
    const LiftedLines lifted = plan.lift(without_names(drawn_as(GetParam(), plan, {plan.set.pieces[1]})));
    ASSERT_EQ(lifted.curves.size(), 1U);
    EXPECT_EQ(lifted.curves[0].attributes.at("tile"), "right");
}

TEST_P(LiftDrawing, LiftsAStraightLineFromSewLineToSewLine) {
    Plan plan;
    const Points2& flat = plan.tiles[1].flattening.positions;
    const Vec2 lower = flat.colwise().minCoeff(), upper = flat.colwise().maxCoeff();
    Points2 tape(2, 2);
    tape << lower.x(), (lower.y() + upper.y()) / 2, upper.x(), (lower.y() + upper.y()) / 2;
    plan.set.pieces[1].lines.push_back({"tape", tape});
    EXPECT_EQ(plan.lift(drawn_as(GetParam(), plan)).curves.size(), 1U);
}

TEST_P(LiftDrawing, LeavesMatchMarksThatAreDrawnBecauseNothingIsAllowed) {
    Plan plan;
    PatternPiece& piece = plan.set.pieces[1];
    PieceNotch notch;
    notch.seam = "S001";
    notch.on_sew = (piece.sew_line.row(0) + piece.sew_line.row(1)) / 2;
    const Vec2 along = (piece.sew_line.row(1) - piece.sew_line.row(0)).transpose().normalized();
    notch.outward = Vec2(along.y(), -along.x());
    piece.notches = {notch};
    const Vec2 end = notch.on_sew - 0.003 * notch.outward;
    Points2 mark(2, 2);
    mark << notch.on_sew.x(), notch.on_sew.y(), end.x(), end.y();
    piece.lines.push_back({"match mark S001", mark});
    EXPECT_TRUE(plan.lift(drawn_as(GetParam(), plan)).curves.empty());
    piece.notches.clear();
    EXPECT_EQ(plan.lift(drawn_as(GetParam(), plan)).curves.size(), 1U) << "any other line is artwork";
}

INSTANTIATE_TEST_SUITE_P(, LiftDrawing, ::testing::Values("svg", "cam", "aama", "astm", "gerber", "et"),
                         [](const auto& format) { return format.param; });

}  // namespace lift_drawing_test
}  // namespace ripstop
