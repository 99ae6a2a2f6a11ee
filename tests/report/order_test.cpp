#include "ripstop/report/tables/order.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "ripstop/nest/nest_pieces.h"
#include "support/loose_pieces.h"

namespace ripstop {
namespace order_test {

using ::testing::HasSubstr;
using ::testing::Not;

/// Two squares of one metre sewn together along a side, with a tape in the seam and hems around them.
PieceSet two_squares() {
    PieceSet set = testing::loose_set({testing::rectangle_piece("A", 1, 1), testing::rectangle_piece("B", 1, 1)});
    set.seam_types = {{"taped", 0.025, 2, true}, {"hem", 0.025, 1, false}};
    for (PatternPiece& piece : set.pieces) {
        for (int e = 0; e < 4; ++e) piece.edges.push_back({e, 1, 0.025, "hem"});
        piece.edges[1].seam_type = "taped";
        piece.edges[1].mates = {{"S1", piece.name == "A" ? "B" : "A", 1}};
    }
    return set;
}

TEST(Bom, CountsASeamOnceWithItsThreadAndTape) {
    const std::string text = bom_csv(two_squares(), nullptr);
    EXPECT_THAT(text, HasSubstr("seam,hem,,,,,,,,,,6,18,0\n"));   // 1 row x 6 m x 3
    EXPECT_THAT(text, HasSubstr("seam,taped,,,,,,,,,,1,6,1\n"));  // 2 rows x 1 m x 3
}

TEST(Bom, HasNoGrossBeforeThePiecesAreLaid) {
    PieceSet set = two_squares();
    set.pieces[0].quantity = 5;
    set.pieces[0].quantity_mirrored = 2;
    const std::string text = bom_csv(set, nullptr);
    EXPECT_THAT(text, HasSubstr("cloth,,isotropic,,8,,8,,,,,,,\n"));
    EXPECT_THAT(text, HasSubstr("piece,A,isotropic,,5,2,1,,,,,,,\n"));
    EXPECT_THAT(text, HasSubstr("piece,B,isotropic,,1,0,1,,,,,,,\n"));
}

TEST(Bom, HasWhatTheMarkersTake) {
    const PieceSet set = two_squares();
    Marker marker{"isotropic", "", 1.5, 2};
    marker.net_area = 2;
    const Markers markers{{marker}, {}};
    EXPECT_THAT(bom_csv(set, &markers), HasSubstr("cloth,,isotropic,,2,,2,3,2,1500,33.33333,,,\n"));
    const Markers lacking{{marker}, {{"B", "is too wide"}}};
    EXPECT_THAT(bom_csv(set, &lacking), HasSubstr("cloth,,isotropic,,2,,2,,,,,,,\n"));
}

TEST(Bom, KeepsClothsApartAndListsNoPatternTwice) {
    PieceSet set = two_squares();
    set.pieces[0].quantity = 2;
    set.pieces[0].colour = "red, dark";
    set.pieces[1].quantity = 0;
    const std::string text = bom_csv(set, nullptr);
    EXPECT_THAT(text, HasSubstr("cloth,,isotropic,\"red, dark\",2,,2,"));
    EXPECT_THAT(text, Not(HasSubstr("piece,B")));
    EXPECT_THAT(text, HasSubstr("seam,taped,,,,,,,,,,1,")) << "B is there, cut by A's pattern";
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) EXPECT_GE(std::count(line.begin(), line.end(), ','), 13) << line;
}

}  // namespace order_test
}  // namespace ripstop
