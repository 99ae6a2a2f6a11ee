#include "ripstop/pipeline/lift_drawing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "ripstop/base/units.h"
#include "ripstop/io/dxf.h"
#include "ripstop/io/dxf_read.h"
#include "ripstop/io/svg.h"
#include "ripstop/io/svg_read.h"
#include "ripstop/report/cut_files.h"
#include "support/flat_tiles.h"

namespace ripstop {
namespace {

/// Two sheets of one size that are bent, not stretched, and a stripe on the second.
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
    LiftedLines lift(const PatternDrawing& drawing) const {
        return lift_drawing(drawing, millimetre, set, [this](const PatternPiece& piece) {
            const FlatTile& tile = piece.name == "left" ? tiles[0] : tiles[1];
            return NamedMesh{piece.name, tile.tile.mesh, tile.flattening.positions};
        });
    }
};

PatternDrawing drawn_as(const std::string& format, const Plan& plan) {
    std::stringstream file;
    const std::vector<Vec2> shifts = lay_out(plan.set.pieces, 0.1);
    if (format == "dxf") {
        write_dxf(file, plan.set.pieces, shifts);
        return read_dxf(file, "sheet.dxf");
    }
    write_svg(file, plan.set.pieces, shifts);
    return read_svg(file, "sheet.svg");
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
    EXPECT_EQ(plan.lift(drawing).pieces, 0);
}

INSTANTIATE_TEST_SUITE_P(, LiftDrawing, ::testing::Values("dxf", "svg"),
                         [](const auto& format) { return format.param; });

}  // namespace
}  // namespace ripstop
