#include "ripstop/pattern/revision/compare_pieces.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ripstop/base/text/units.h"
#include "ripstop/nest/laid_piece.h"
#include "ripstop/pattern/revision/fit_outline.h"
#include "support/loose_pieces.h"

namespace ripstop {
namespace compare_pieces_test {

using ::testing::IsEmpty;
using testing::loose_set;

/// A trapezoid with one edge per side and a notch in the middle of the first.
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
    piece = laid_piece(piece, placement);
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
        EXPECT_NEAR(found[0].grain_turn, -turn, 1e-6);  // the tolerance of the iteration
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
    EXPECT_NEAR(found[0].distance, 0.003, 1e-4);  // the side that moved by 3 mm is slanted
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

/// The same piece with its edges numbered from another corner.
PatternPiece renumbered(const PatternPiece& piece, int on) {
    PatternPiece other = piece;
    for (int i = 0; i < 4; ++i) {
        other.sew_line.row(i) = piece.sew_line.row((i + on) % 4);
        other.edges[static_cast<std::size_t>(i)] = piece.edges[static_cast<std::size_t>((i + on) % 4)];
        other.edges[static_cast<std::size_t>(i)].first = i;
    }
    for (PieceNotch& notch : other.notches) notch.edge = (notch.edge + 4 - on) % 4;
    return other;
}

TEST(ComparePieces, MatchesEdgesByWhereTheyLieNotByTheirNumbers) {
    PatternPiece before = trapezoid();
    before.edges[1].mates = {{"S0001", "U", 1}};
    for (int on = 1; on < 4; ++on) {
        PatternPiece after = renumbered(before, on);
        for (PieceEdge& edge : after.edges)
            for (Mate& mate : edge.mates) mate.seam = "S0099";
        EXPECT_THAT(changes(before, after), IsEmpty()) << on;
        EXPECT_THAT(changes(before, turned(after, 0, Vec2(2, 1))), IsEmpty()) << on;
        after.edges[static_cast<std::size_t>(4 - on)].seam_type = "taped";  // the first one
        const auto found = changes(before, after);
        ASSERT_EQ(found.size(), 1u);
        ASSERT_EQ(found[0].edges.size(), 1u);
        EXPECT_EQ(found[0].edges[0].edge, 0);
        EXPECT_EQ(found[0].edges[0].edge_after, 4 - on);
    }
}

TEST(ComparePieces, TellsHowNotchesAreCutAndWhomAnEdgeIsSewnTo) {
    PatternPiece before = trapezoid();
    before.edges[1].mates = {{"S0001", "U", 0.5}, {"S0002", "V", 0.5}};
    PatternPiece deeper = before;
    deeper.notches[0].depth = 0.008;
    PatternPiece twice = before;
    twice.notches[0].count = 2;
    PatternPiece other_mate = before;
    other_mate.edges[1].mates[1].piece = "W";
    PatternPiece longer = before;
    longer.edges[1].mates[0].length = 0.6;
    ASSERT_EQ(changes(before, deeper).size(), 1u);
    EXPECT_EQ(changes(before, deeper)[0].edges.at(0).notch_depth_after, 0.008);
    ASSERT_EQ(changes(before, twice).size(), 1u);
    EXPECT_EQ(changes(before, twice)[0].edges.at(0).doubles_after, 1);
    ASSERT_EQ(changes(before, other_mate).size(), 1u);
    EXPECT_EQ(changes(before, other_mate)[0].edges.at(0).mates_after.at(1).piece, "W");
    EXPECT_EQ(changes(before, longer).size(), 1u);
}

TEST(ComparePieces, FindsDrawnLinesThatCameWentOrMoved) {
    Points2 tape(2, 2), split(3, 2);
    tape << 0.2, 0.5, 1.8, 0.5;
    split << 0.2, 0.5, 1.0, 0.5, 1.8, 0.5;
    PatternPiece before = trapezoid();
    before.lines = {{"tape", tape}, {"tape", tape + Points2::Constant(2, 2, 0.1)}};
    PatternPiece after = before;
    std::swap(after.lines[0], after.lines[1]);
    after.lines[1].points = split;
    EXPECT_THAT(changes(before, after), IsEmpty()) << "neither order nor points between matter";
    EXPECT_THAT(changes(before, turned(after, 0, Vec2(3, 1))), IsEmpty());
    after.lines[1].points.col(1).array() -= 0.02;
    after.lines.push_back({"logo", tape});
    const auto found = changes(before, after);
    ASSERT_EQ(found.size(), 1u);
    ASSERT_EQ(found[0].lines.size(), 2u);
    EXPECT_EQ(found[0].lines[0].kind, LineChange::Kind::moved);
    EXPECT_NEAR(found[0].lines[0].distance, 0.02, 1e-9);
    EXPECT_EQ(found[0].lines[1].line, "logo");
    EXPECT_EQ(found[0].lines[1].kind, LineChange::Kind::added);
    EXPECT_EQ(changes(after, before).at(0).lines.at(1).kind, LineChange::Kind::gone);
}

TEST(ComparePieces, TellsASewLineThatMovedWithinTheCutLineAndAnArrowThatTurned) {
    PatternPiece before = trapezoid();
    before.cut_line.resize(4, 2);
    before.cut_line << -0.1, -0.1, 2.1, -0.1, 1.8, 1.1, 0.1, 1.1;
    before.grain_line.resize(2, 2);
    before.grain_line << 0.5, 0.5, 1.5, 0.5;
    PatternPiece after = before;
    after.sew_line.col(0).array() += 0.005;
    after.notches[0].on_sew.x() += 0.005;
    auto found = changes(before, after);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found[0].sew_distance_fitted, 0.005, 1e-9);
    EXPECT_EQ(found[0].distance_fitted, 0);
    after = before;
    after.grain_line << 1, 0.2, 1, 0.8;
    found = changes(before, after);
    ASSERT_EQ(found.size(), 1u);
    ASSERT_EQ(found[0].fields.size(), 1u);
    EXPECT_EQ(found[0].fields[0].field, "grain_line_deg");
    EXPECT_EQ(found[0].fields[0].after, "90.000");
}

TEST(CompareSeamTypes, TellsAllowanceRowsAndTape) {
    PieceSet before = loose_set({trapezoid()});
    before.seam_types = {{"flat-felled", 0.025, 2, false}, {"plain", 0.013, 1, false}};
    PieceSet after = before;
    EXPECT_THAT(compare_seam_types(before, after, 1e-5), IsEmpty());
    after.seam_types[0] = {"flat-felled", 0.03, 3, true};
    const auto found = compare_seam_types(before, after, 1e-5);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].seam_type, "flat-felled");
    ASSERT_EQ(found[0].fields.size(), 3u);
    EXPECT_EQ(found[0].fields[0].after, "30");
    EXPECT_EQ(found[0].fields[1].before, "2");
    EXPECT_EQ(found[0].fields[2].after, "true");
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

}  // namespace compare_pieces_test
}  // namespace ripstop
