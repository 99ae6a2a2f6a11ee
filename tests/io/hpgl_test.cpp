#include "ripstop/io/print/hpgl.h"

#include <gmock/gmock.h>

#include <cmath>
#include <regex>
#include <sstream>

#include "ripstop/base/error.h"
#include "ripstop/io/print/letters.h"
#include "support/golden.h"
#include "support/outside.h"
#include "support/pattern_pieces.h"
#include "support/plotter.h"
#include "support/refusal.h"

namespace ripstop {
namespace hpgl_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

/// Coordinates are rounded to 0.025 mm, so each end of a stroke is off by at most 0.018 mm.
double rounding(const Points2& line) {
    return 2 * 0.018e-3 * static_cast<double>(line.rows());
}

std::string hpgl(const std::vector<PatternPiece>& pieces, const HpglOptions& options = {}) {
    std::ostringstream out;
    write_hpgl(out, pieces, {}, options);
    return out.str();
}

/// Removes the letters; only the lines of the piece and the square remain.
PatternPiece unlabelled(PatternPiece piece) {
    piece.labels.clear();
    return piece;
}

TEST(Hpgl, HasThePensDoWhatTheirNumbersSay) {
    const PatternPiece piece = unlabelled(testing::band("P", 0.5, 0.3, 0.02));
    const testing::Plot plot = testing::plot_of(hpgl({piece})), bare = testing::plot_of(hpgl({}));
    EXPECT_EQ(plot.fault, "");
    EXPECT_TRUE(plot.is_ended);
    EXPECT_THAT(plot.pens, ElementsAre(1, 3, 2, 1, 0)) << "drawn first, cut last; then the square";
    EXPECT_NEAR(plot.length(2), testing::cut_length(piece), rounding(piece.cut_line));
    ASSERT_EQ(plot.strokes.at(2).size(), 1U);
    EXPECT_EQ(plot.strokes.at(2)[0].row(0), plot.strokes.at(2)[0].bottomRows(1)) << "the cut closes";
    EXPECT_EQ(plot.strokes.at(3).size(), 3U) << "a single and a double notch";
    EXPECT_NEAR(plot.length(3), 3 * 0.004, 3 * 0.05e-3);
    const double drawn = 2 * piece.edges[0].length + 2 * 0.3 + 0.8 * 0.3 + 0.4 * 0.5 + 2 * std::hypot(0.012, 0.0036);
    EXPECT_NEAR(plot.length(1) - bare.length(1), drawn, 2 * rounding(piece.sew_line))
        << "sew line, internal line, arrow and its barbs";
}

TEST(Hpgl, DrawsYUpAndNothingMirrored) {
    PatternPiece piece;
    piece.sew_line.resize(3, 2);
    piece.sew_line << 0, 0, 0.2, 0, 0, 0.1;
    const testing::Plot plot = testing::plot_of(hpgl({piece}));
    Points2 expected(4, 2);
    expected << 0, 0, 8000, 0, 0, 4000, 0, 0;
    EXPECT_EQ(plot.strokes.at(2).at(0), expected);
    Points2 square = plot.strokes.at(1).at(0);  // nothing is drawn on this piece
    EXPECT_EQ(square.colwise().maxCoeff() - square.colwise().minCoeff(), Eigen::RowVector2d(4000, 4000)) << "100 mm";
}

TEST(Hpgl, CutsAPieceWithoutCutLineOnTheSewLine) {
    const PatternPiece piece = unlabelled(testing::odd_pieces()[2]);
    const testing::Plot plot = testing::plot_of(hpgl({piece}));
    EXPECT_NEAR(plot.length(2), 2 * (0.3 + 0.1), rounding(piece.sew_line));
}

TEST(Hpgl, KeepsCommandsShortAndPutsThePenAway) {
    const std::string text = hpgl(testing::odd_pieces());
    EXPECT_THAT(text, StartsWith("IN;\nPS"));
    const testing::Plot plot = testing::plot_of(text);
    EXPECT_EQ(plot.fault, "");
    EXPECT_LE(plot.longest, 16U);
    EXPECT_TRUE(plot.is_ended);
    EXPECT_EQ(text.substr(text.size() - 8), "PU;SP0;\n");
}

TEST(Hpgl, DrawsFortyMetresToTheEnd) {
    const PatternPiece piece = unlabelled(testing::band("long", 40, 1.4, 0.1));
    const testing::Plot plot = testing::plot_of(hpgl({piece}));
    EXPECT_NEAR(plot.length(2), testing::cut_length(piece), rounding(piece.cut_line));
    EXPECT_NEAR(static_cast<double>(plot.largest) * 0.025e-3, 40.024 + 0.12, 0.05e-3) << "the piece and the square";
    EXPECT_NEAR(plot.size.x(), static_cast<double>(plot.largest), 1);
}

TEST(Hpgl, CutsLongPiecesIntoFramesForPlottersOfSixteenBits) {
    const PatternPiece piece = unlabelled(testing::band("long", 40, 1.3, 0.1));
    const std::string text = hpgl({piece}, {.frame = 1.5});
    EXPECT_THAT(text, ::testing::Not(HasSubstr("PS")));
    const testing::Plot plot = testing::plot_of(text, 1.5 / 0.025e-3);
    EXPECT_EQ(plot.fault, "");
    EXPECT_EQ(plot.frames, 27) << "40.144 m";
    EXPECT_LE(plot.largest, 32767);
    EXPECT_NEAR(plot.length(2), testing::cut_length(piece), rounding(piece.cut_line) + 27 * 4 * 0.05e-3);
    // Lines that one frame cuts continue in the next at the same place.
    const testing::Plot whole = testing::plot_of(hpgl({piece}));
    Vec2 lower(1e9, 1e9), upper(-1e9, -1e9), whole_lower = lower, whole_upper = upper;
    for (const Points2& stroke : plot.strokes.at(2)) {
        lower = lower.cwiseMin(Vec2(stroke.colwise().minCoeff()));
        upper = upper.cwiseMax(Vec2(stroke.colwise().maxCoeff()));
    }
    for (const Points2& stroke : whole.strokes.at(2)) {
        whole_lower = whole_lower.cwiseMin(Vec2(stroke.colwise().minCoeff()));
        whole_upper = whole_upper.cwiseMax(Vec2(stroke.colwise().maxCoeff()));
    }
    EXPECT_LT((upper - lower - whole_upper + whole_lower).cwiseAbs().maxCoeff(), 1.5) << "units of 0.025 mm";
}

std::string refusal(const std::vector<PatternPiece>& pieces, double frame) {
    return testing::refusal([&] { hpgl(pieces, {.frame = frame}); });
}

TEST(Hpgl, RefusesWhatNoPlotterCounts) {
    EXPECT_THAT(refusal({testing::band("vast", 300, 1)}, 0), HasSubstr("beyond the 209.72 m that HPGL counts"));
    EXPECT_THAT(refusal({testing::band("wide", 3, 2)}, 0.8), HasSubstr("0.82 m that HPGL counts on either side"));
    EXPECT_THAT(refusal({}, 2), HasSubstr("a frame of 2.00 m; give 0.10 m to 1.64 m"));
    EXPECT_THAT(refusal({}, 0.01), HasSubstr("a frame of 0.01 m"));
    EXPECT_THAT(refusal({}, -1), HasSubstr("a frame of -1.00 m"));
}

TEST(Hpgl, WritesAnyNameAsOutlines) {
    PatternPiece plain = testing::band("Dracek", 0.5, 0.3), accents = testing::band("Dr\u00e1\u010dek", 0.5, 0.3);
    const double more = testing::plot_of(hpgl({accents})).length(1) - testing::plot_of(hpgl({plain})).length(1);
    EXPECT_GT(more, 2 * 0.003) << "an acute and a caron, each outline longer than a few mm at letters of 20 mm";
}

TEST(Letters, AreAsHighAsTheyAreCalledAndWhereTheyAreCalled) {
    Vec2 lower(1, 1), upper(-1, -1);
    for (const Points2& outline : letter_outlines({"H", Vec2(0.1, 0.2), 0.02, 0})) {
        EXPECT_EQ(outline.row(0), outline.bottomRows(1));
        lower = lower.cwiseMin(Vec2(outline.colwise().minCoeff()));
        upper = upper.cwiseMax(Vec2(outline.colwise().maxCoeff()));
    }
    // an H is symmetric; cairo rounds to 1/256 of 1/200 of the height
    EXPECT_NEAR(upper.y() - lower.y(), 0.02, 1e-5);
    EXPECT_NEAR((lower.x() + upper.x()) / 2, 0.1, 1e-4);
    EXPECT_NEAR((lower.y() + upper.y()) / 2, 0.2, 1e-5);
}

TEST(Letters, TurnCounterClockwise) {
    const auto level = letter_outlines({"L", Vec2::Zero(), 0.02, 0}),
               upright = letter_outlines({"L", Vec2::Zero(), 0.02, std::acos(0.0)});
    ASSERT_EQ(level.size(), upright.size());
    for (Eigen::Index i = 0; i < level[0].rows(); ++i) {
        EXPECT_NEAR(upright[0](i, 0), -level[0](i, 1), 1e-12);
        EXPECT_NEAR(upright[0](i, 1), level[0](i, 0), 1e-12);
    }
}

/// The total length of the paths in hp2xx's SVG, which is in points, y down.
double length_in_svg(const std::string& svg) {
    const std::regex path("<path d=\"([^\"]*)\""), number("(-?[0-9.]+), (-?[0-9.]+)");
    double sum = 0;
    for (std::sregex_iterator it(svg.begin(), svg.end(), path), end; it != end; ++it) {
        const std::string d = (*it)[1];
        Vec2 before(0, 0);
        bool is_first = true;
        for (std::sregex_iterator p(d.begin(), d.end(), number), none; p != none; ++p) {
            const Vec2 point(std::stod((*p)[1]), std::stod((*p)[2]));
            if (!is_first) sum += (point - before).norm();
            before = point;
            is_first = false;
        }
    }
    return sum * 0.0254 / 72;
}

TEST(Hpgl, IsReadAlikeByHp2xx) {
    if (testing::run_command("hp2xx -q -m svg -f /dev/null /dev/null").code > 1) GTEST_SKIP() << "no hp2xx here";
    const testing::ScratchDirectory scratch;
    for (const double length : {0.5, 40.0}) {
        const PatternPiece piece = testing::band("B\u00edl\u00fd", length, 0.3, 0.02);
        const std::string text = hpgl({piece});
        testing::write_text(scratch.path("p.plt"), text);
        const auto read =
            testing::run_command("hp2xx -q -t -m svg -f " + scratch.path("p.svg") + " " + scratch.path("p.plt"));
        ASSERT_EQ(read.code, 0) << read.output;
        const testing::Plot plot = testing::plot_of(text);
        const double all = plot.length(1) + plot.length(2) + plot.length(3);
        // it rounds to thousandths of a point, 0.35 micrometres, at some 2,000 points
        EXPECT_NEAR(length_in_svg(testing::content(scratch.path("p.svg"))), all, 1e-3) << length;
    }
}

TEST(Hpgl, IsWhatItWasLastTime) {
    testing::expect_golden("band.plt", hpgl({testing::band("G01P01", 0.25, 0.12, 0.01)}));
}

}  // namespace hpgl_test
}  // namespace ripstop
