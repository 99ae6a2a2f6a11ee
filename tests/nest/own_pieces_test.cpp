#include "ripstop/nest/own_pieces.h"

#include <gtest/gtest.h>

#include <set>

#include "ripstop/geometry/polygon.h"
#include "ripstop/nest/laid_piece.h"
#include "ripstop/nest/nest_pieces.h"
#include "support/loose_pieces.h"

namespace ripstop {
namespace own_pieces_test {

/// An L with unequal legs, different from its mirror images and rotations.
Points2 bent() {
    Points2 corners(6, 2);
    corners << 0, 0, 0.9, 0, 0.9, 0.2, 0.3, 0.2, 0.3, 0.5, 0, 0.5;
    return corners;
}

Points2 mirrored(Points2 outline) {
    outline.col(1) *= -1;
    return outline.colwise().reverse();
}

/// Four pieces of one pattern with different flat positions: shifted, turned by half, mirrored, and both.
PieceSet four_of_a_pattern() {
    std::vector<PatternPiece> pieces{testing::loose_piece("A", bent())};
    Points2 turned = -bent();
    turned.rowwise() += Eigen::RowVector2d(3, -2);
    pieces.push_back(testing::loose_piece("B", turned));
    pieces.push_back(testing::loose_piece("C", mirrored(bent())));
    pieces.push_back(testing::loose_piece("D", mirrored(turned)));
    pieces[0].quantity = 2;
    pieces[0].quantity_mirrored = 2;
    for (std::size_t i = 1; i < 4; ++i) {
        pieces[i].quantity = 0;
        pieces[i].pattern = pieces[0].name;
        pieces[i].mirrored = i >= 2;
    }
    return testing::loose_set(pieces);
}

class OwnPieces : public ::testing::TestWithParam<bool> {
  protected:
    NestOptions options() const {
        NestOptions options;
        options.roll_width = 1.2;
        options.rounds = 2;
        options.may_flip = GetParam();
        return options;
    }
};

TEST_P(OwnPieces, AreLaidWhereTheCopiesOfTheirPatternWouldBe) {
    const PieceSet own = four_of_a_pattern();
    PieceSet copies = own;
    copies.pieces.resize(1);
    const Marker laid = nest_pieces(own, options()).markers.at(0), plain = nest_pieces(copies, options()).markers.at(0);
    ASSERT_EQ(laid.placements.size(), 4U);
    ASSERT_EQ(plain.placements.size(), 4U);
    std::set<std::size_t> pieces;
    for (std::size_t i = 0; i < 4; ++i) {
        const Placement &here = laid.placements[i], &there = plain.placements[i];
        pieces.insert(here.piece);
        EXPECT_FALSE(here.mirrored);
        EXPECT_EQ(here.copy, 0);
        EXPECT_GT(there.copy, 0);
        EXPECT_TRUE(GetParam() || !here.is_drawn_mirrored()) << "the outside of the cloth is up";
        const Points2 outline = here.placed(own.pieces[here.piece].outline());
        const Points2 wanted = there.placed(copies.pieces[0].outline());
        for (Eigen::Index p = 0; p < outline.rows(); ++p)
            EXPECT_LT(distance_to_outline(wanted, outline.row(p)), 1e-9) << own.pieces[here.piece].name;
    }
    EXPECT_EQ(pieces.size(), 4U) << "each piece once";
}

TEST_P(OwnPieces, CarryTheirNamesWithoutNumber) {
    const PieceSet set = four_of_a_pattern();
    std::set<std::string> names;
    const Markers markers = nest_pieces(set, options());
    for (const Placement& placement : markers.markers.at(0).placements)
        names.insert(laid_piece(set.pieces[placement.piece], placement).name);
    EXPECT_EQ(names, (std::set<std::string>{"A", "B", "C", "D"}));
}

TEST_P(OwnPieces, AllLieOneWayWhereNoneMayBeTurned) {
    const PieceSet set = four_of_a_pattern();
    NestOptions one_way = options();
    one_way.may_turn = false;
    const Markers markers = nest_pieces(set, one_way);
    PieceSet singly = set;  // as the judge counts them
    for (PatternPiece& piece : singly.pieces) piece.quantity = 1, piece.quantity_mirrored = 0;
    EXPECT_EQ(testing::faults_of(singly, markers, one_way.gap), "");
    ASSERT_EQ(markers.markers.at(0).placements.size(), 4U);
    for (const Placement& placement : markers.markers[0].placements)
        EXPECT_NEAR(placement.turn, 0, 1e-12) << set.pieces[placement.piece].name;
}

INSTANTIATE_TEST_SUITE_P(, OwnPieces, ::testing::Bool(),
                         [](const auto& flip) { return flip.param ? "flipped" : "face_up"; });

}  // namespace own_pieces_test
}  // namespace ripstop
