#include "ripstop/io/print/paper.h"

#include <gmock/gmock.h>

#include "ripstop/base/error.h"
#include "ripstop/geometry/polygon.h"
#include "support/pattern_pieces.h"
#include "support/refusal.h"

namespace ripstop {
namespace paper_test {

using ::testing::HasSubstr;

std::string refusal(const std::string& paper) {
    return testing::refusal([&] { paper_named(paper); });
}

TEST(Paper, IsKnownByNameOrByTheWidthOfTheRoll) {
    EXPECT_EQ(paper_named("A4").height, 0.297);
    EXPECT_EQ(paper_named("letter").name, "Letter");
    EXPECT_TRUE(paper_named("roll").is_roll);
    EXPECT_EQ(paper_named("914mm").height, 0.914);
    EXPECT_THAT(refusal("a9"),
                HasSubstr("no paper \"a9\"; known: roll, a4, a3, a2, a1, a0, letter, tabloid, or the width of a roll"));
    EXPECT_THAT(refusal(""), HasSubstr("known: roll"));
    EXPECT_THAT(refusal("914"), HasSubstr("--paper"));
    EXPECT_THAT(refusal("9mm"), HasSubstr("200 mm to 5 m"));
    EXPECT_THAT(refusal("-1m"), HasSubstr("no paper"));
}

/// Every kind of piece on every paper: each point of the outline is inside the printable area of a page, and
/// neighbours share the stated overlap.
TEST(PageGrid, ShowsEveryPointOfThePiece) {
    const PatternPiece pieces[] = {testing::band("wide", 2.31, 1.47, 0.05), testing::band("small", 0.1, 0.05),
                                   testing::band("tall", 0.4, 1.9), testing::band("long", 12.3, 0.6)};
    for (const PatternPiece& piece : pieces)
        for (const char* name : {"a4", "a3", "a0", "letter", "tabloid", "roll", "610mm"}) {
            const Paper paper = paper_named(name);
            const PageGrid grid = make_page_grid(piece, paper);
            for (Eigen::Index i = 0; i < piece.cut_line.rows(); ++i) {
                const Vec2 p = piece.cut_line.row(i);
                const auto shows = [&p](const PageWindow& window) {
                    return ((p - window.lower).array() > 0.002).all() && ((window.upper - p).array() > 0.002).all();
                };
                EXPECT_TRUE(std::any_of(grid.windows.begin(), grid.windows.end(), shows))
                    << piece.name << " on " << name << ", point " << i;
            }
            EXPECT_LE(std::max(grid.page.x(), grid.page.y()), std::max(paper.width, paper.height) + 1e-9);
            EXPECT_LE(grid.page.x(), 200 * 0.0254) << "PDF ends there";
            if (paper.is_roll) {
                EXPECT_LE(grid.page.y(), paper.height + 1e-9);
            }
            for (const PageWindow& window : grid.windows) {
                const PageWindow& first = grid.windows.front();
                const Vec2 room = grid.page - Vec2::Constant(2 * Paper::margin);
                EXPECT_TRUE((window.upper - window.lower).isApprox(room, 1e-12));
                const Vec2 step = room - Vec2::Constant(Paper::overlap);
                EXPECT_NEAR(window.lower.x() - first.lower.x(), (window.column - first.column) * step.x(), 1e-12);
                EXPECT_NEAR(window.lower.y() - first.lower.y(), (first.row - window.row) * step.y(), 1e-12);
            }
        }
}

TEST(PageGrid, LeavesOutPagesWithoutPiece) {
    PatternPiece piece;
    piece.sew_line.resize(3, 2);  // half of a square of 2 m: nearly half of its pages are empty
    piece.sew_line << 0, 0, 2, 0, 0, 2;
    const PageGrid grid = make_page_grid(piece, paper_named("a4"));
    const auto all = static_cast<std::size_t>(grid.columns * grid.rows);
    EXPECT_LT(grid.windows.size(), all * 2 / 3);
    EXPECT_GT(grid.windows.size(), all / 2);
    EXPECT_FALSE(grid.has(grid.columns - 1, 0));
    EXPECT_TRUE(grid.has(0, 0));
    const PageGrid whole = make_page_grid(testing::band("square", 2, 2), paper_named("a4"));
    EXPECT_EQ(whole.windows.size(), static_cast<std::size_t>(whole.columns * whole.rows))
        << "the inside holds it together";
}

TEST(PageGrid, TurnsThePaperWhereThatTakesFewerPages) {
    EXPECT_EQ(make_page_grid(testing::band("wide", 0.24, 0.15), paper_named("a4")).windows.size(), 1U);
    EXPECT_EQ(make_page_grid(testing::band("tall", 0.15, 0.24), paper_named("a4")).windows.size(), 1U);
}

TEST(PageGrid, PutsAPieceOfARollOnOnePageUpToFiveMetres) {
    EXPECT_EQ(make_page_grid(testing::band("long", 4.9, 1.5), paper_named("roll")).windows.size(), 1U);
    EXPECT_EQ(make_page_grid(testing::band("longer", 40, 1.5), paper_named("roll")).windows.size(), 9U);
    EXPECT_EQ(make_page_grid(testing::band("wide", 4.9, 1.5), paper_named("914mm")).rows, 2);
}

TEST(PageGrid, RefusesMorePagesThanAnybodyGlues) {
    try {
        make_page_grid(testing::band("vast", 900, 90), paper_named("a4"));
        FAIL();
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("piece \"vast\" takes more than 20000 pages; print it on larger paper"));
    }
}

TEST(PageWindow, IsNamedByRowAndColumn) {
    const auto name = [](int column, int row) { return PageWindow{column, row, {}, {}}.name(); };
    EXPECT_EQ(name(0, 0), "A1");
    EXPECT_EQ(name(11, 2), "C12");
    EXPECT_EQ(name(0, 25), "Z1");
    EXPECT_EQ(name(0, 26), "AA1");
    EXPECT_EQ(name(0, 26 * 27), "AAA1");
}

}  // namespace paper_test
}  // namespace ripstop
