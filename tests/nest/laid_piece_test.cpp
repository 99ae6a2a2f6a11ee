#include "ripstop/model/piece/marker.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "ripstop/geometry/polygon.h"
#include "ripstop/nest/laid_piece.h"
#include "support/loose_pieces.h"

namespace ripstop {
namespace marker_test {

/// Edges of 3, 2, sqrt(2), 2 and 1 m from the second corner, a notch on the right edge of 2 m, two lines of text.
PatternPiece marked_piece() {
    Points2 outline(5, 2);
    outline << 0, 0, 3, 0, 3, 2, 1, 2, 0, 1;
    PatternPiece piece = testing::loose_piece("P", outline);
    piece.cut_line = outline;
    const double lengths[] = {3, 2, 2, std::sqrt(2.0), 1};
    for (int e = 0; e < 5; ++e) {
        piece.edges.push_back({e, lengths[e]});
        piece.edges.back().mates = {{std::string("S").append(std::to_string(e)), "Q", lengths[e]}};
    }
    piece.notches.push_back({1, std::string("S1"), 0.5, Vec2(3, 0.5), Vec2(1, 0), 0, 0.005});
    piece.labels = {{"P", Vec2(1.5, 1), 0.04, 0}, {"cut 3 + 2 mirrored", Vec2(1.5, 0.9), 0.02, 0, true}};
    piece.quantity = 3;
    piece.quantity_mirrored = 2;
    return piece;
}

double length_of(const Points2& line) {
    double length = 0;
    for (Eigen::Index i = 0; i + 1 < line.rows(); ++i) length += (line.row(i + 1) - line.row(i)).norm();
    return length;
}

TEST(LaidPiece, KeepsLengthsEdgesAndNotchesInEveryPlace) {
    const PatternPiece piece = marked_piece();
    for (const bool mirrored : {false, true})
        for (const bool face_down : {false, true})
            for (const double turn : {0.0, std::numbers::pi, 0.03}) {
                const Placement placement{0, 2, mirrored, face_down, turn, Vec2(7, 0.3)};
                const PatternPiece laid = laid_piece(piece, placement);
                EXPECT_NEAR(signed_area(laid.sew_line), signed_area(piece.sew_line), 1e-12);
                EXPECT_NEAR(signed_area(laid.cut_line), signed_area(piece.cut_line), 1e-12);
                int previous = -1;
                for (std::size_t e = 0; e < laid.edges.size(); ++e) {
                    EXPECT_GT(laid.edges[e].first, previous);
                    previous = laid.edges[e].first;
                    EXPECT_NEAR(length_of(laid.edge_line(e)), laid.edges[e].length, 1e-12);
                }
                const PieceNotch& notch = laid.notches.at(0);
                EXPECT_EQ(laid.edges.at(static_cast<std::size_t>(notch.edge)).mates.at(0).seam, "S1");
                EXPECT_NEAR(distance_to_outline(laid.sew_line, notch.on_sew), 0, 1e-12);
                EXPECT_FALSE(contains(laid.sew_line, Vec2(notch.on_sew + 1e-3 * notch.outward)));
                EXPECT_EQ(laid.name, mirrored ? "P mirrored 2/5" : "P 2/5");
            }
}

TEST(LaidPiece, WritesUprightAndInOrder) {
    const PatternPiece piece = marked_piece();
    for (const bool mirrored : {false, true})
        for (const double turn : {0.0, std::numbers::pi, std::numbers::pi - 0.03}) {
            const PatternPiece laid = laid_piece(piece, {0, 1, mirrored, false, turn, Vec2::Zero()});
            const Label &name = laid.labels.at(0), &copy = laid.labels.at(1);
            EXPECT_LT(std::abs(name.turn), 0.04);
            EXPECT_EQ(name.text, mirrored ? "P mirrored" : "P");
            EXPECT_EQ(copy.text, "1/5");
            EXPECT_LT(copy.middle.y(), name.middle.y());
            EXPECT_NEAR((copy.middle - name.middle).norm(), 0.1, 1e-12);
            EXPECT_TRUE(contains(laid.sew_line, name.middle));
        }
}

}  // namespace marker_test
}  // namespace ripstop
