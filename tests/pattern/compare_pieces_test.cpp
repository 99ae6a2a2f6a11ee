#include "ripstop/pattern/compare_pieces.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ripstop/base/units.h"
#include "support/loose_pieces.h"

namespace ripstop {
namespace {

using ::testing::IsEmpty;
using testing::loose_set;

/// A trapezoid with an edge a side and a notch in the middle of the first.
PatternPiece trapezoid(double width = 2) {
    Points2 outline(4, 2);
    outline << 0, 0, width, 0, width - 0.3, 1, 0.2, 1;
    PatternPiece piece = testing::loose_piece("T", outline);
    for (int e = 0; e < 4; ++e) {
        const Vec2 way = outline.row((e + 1) % 4) - outline.row(e);
        piece.edges.push_back({e, way.norm(), 0.025, "flat-felled"});
    }
    piece.notches.push_back({0, "S1", 1, Vec2(1, 0), Vec2(0, -1), 0.025, 0.005});
    return piece;
}

PatternPiece turned(PatternPiece piece, double turn, const Vec2& shift) {
    const Placement placement{0, 1, false, false, turn, shift};
    const std::string name = piece.name;
    piece = placed_piece(piece, placement);
    piece.name = name;
    return piece;
}

std::vector<PieceChange> changes(const PatternPiece& before, const PatternPiece& after) {
    return compare_pieces(loose_set({before}), loose_set({after}), 1e-5);
}

TEST(ComparePieces, FindsNothingInTheSamePieces) {
    EXPECT_THAT(changes(trapezoid(), trapezoid()), IsEmpty());
    EXPECT_THAT(changes(trapezoid(), turned(trapezoid(), 0, Vec2(0.3, -2))), IsEmpty()) << "where it lies is no change";
}

TEST(ComparePieces, TellsByHowMuchTheGrainTurned) {
    for (const double turn : {5 * degree, -30 * degree, 90 * degree, 170 * degree}) {
        const auto found = changes(trapezoid(), turned(trapezoid(), turn, Vec2(1, 1)));
        ASSERT_EQ(found.size(), 1u);
        EXPECT_NEAR(found[0].grain_turn, -turn, 1e-6);  // where the iteration stops
        EXPECT_NEAR(found[0].distance_fitted, 0, 1e-6);
        EXPECT_GT(found[0].distance, 0.05);
        EXPECT_THAT(found[0].edges, IsEmpty());
    }
}

TEST(ComparePieces, MeasuresAnEdgeThatGrew) {
    const auto found = changes(trapezoid(), trapezoid(2.003));
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found[0].area_after - found[0].area_before, 0.003, 1e-12);
    EXPECT_NEAR(found[0].perimeter_after - found[0].perimeter_before, 0.006, 1e-12);
    EXPECT_NEAR(found[0].distance, 0.003, 1e-4);  // the side that moved by 3 mm leans
    EXPECT_GT(found[0].distance_fitted, 0.001);
    EXPECT_LT(found[0].distance_fitted, 0.0025) << "half at either end";
    ASSERT_EQ(found[0].edges.size(), 2u);
    EXPECT_EQ(found[0].edges[0].edge, 0);
    EXPECT_NEAR(found[0].edges[0].length_after - found[0].edges[0].length_before, 0.003, 1e-12);
    EXPECT_EQ(found[0].edges[1].edge, 2);
    EXPECT_NEAR(found[0].grain_turn, 0, 1e-3);
}

TEST(ComparePieces, NamesNotchesTypesAllowancesAndFields) {
    PatternPiece after = trapezoid();
    after.notches[0].on_sew.x() += 0.004;
    after.edges[2].seam_type = "taped";
    after.edges[2].allowance = 0.03;
    after.colour = "red";
    after.quantity = 24;
    const auto found = changes(trapezoid(), after);
    ASSERT_EQ(found.size(), 1u);
    ASSERT_EQ(found[0].edges.size(), 2u);
    EXPECT_NEAR(found[0].edges[0].notch_moved, 0.004, 1e-12);
    EXPECT_EQ(found[0].edges[1].type_after, "taped");
    EXPECT_EQ(found[0].edges[1].allowance_after, 0.03);
    ASSERT_EQ(found[0].fields.size(), 2u);
    EXPECT_EQ(found[0].fields[0].field, "colour");
    EXPECT_EQ(found[0].fields[1].after, "24");
}

TEST(ComparePieces, TellsWhatIsGoneAndWhatIsNew) {
    PatternPiece other = trapezoid();
    other.name = "U";
    const auto found = changes(trapezoid(), other);
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0].kind, PieceChange::Kind::gone);
    EXPECT_EQ(found[0].piece, "T");
    EXPECT_EQ(found[1].kind, PieceChange::Kind::added);
    EXPECT_NEAR(found[1].area_after, 1.75, 1e-12);
}

TEST(ComparePieces, PassesWhatIsWithinTheTolerance) {
    EXPECT_THAT(compare_pieces(loose_set({trapezoid()}), loose_set({trapezoid(2.003)}), 0.01), IsEmpty());
}

TEST(OutlineDistance, IsTheLargestOfEither) {
    const Points2 square = testing::rectangle_piece("", 1, 1).sew_line;
    EXPECT_NEAR(outline_distance(square, square), 0, 1e-15);
    EXPECT_NEAR(outline_distance(square, testing::rectangle_piece("", 1.5, 1).sew_line), 0.5, 1e-12);
}

}  // namespace
}  // namespace ripstop
