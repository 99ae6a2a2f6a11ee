#include "ripstop/report/figures/wide_pieces.h"

#include <gmock/gmock.h>

namespace ripstop {
namespace wide_pieces_test {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

PatternPiece sheet(const std::string& name, double width, int quantity, const std::string& fabric) {
    PatternPiece piece{name, Points2(4, 2)};
    piece.sew_line << 0, 0, 5, 0, 5, width, 0, width;
    piece.quantity = quantity;
    piece.fabric = fabric;
    return piece;
}

PieceSet set_of(const std::vector<PatternPiece>& pieces) {
    Fabric nylon, silk;
    nylon.name = "nylon";
    nylon.roll_width = 1.5;
    silk.name = "silk";
    silk.roll_width = 1;
    return {"a.obj", "1", pieces, {nylon, silk}, {}};
}

TEST(TooWidePieces, AreCountedByTheirPatternsFabricByFabric) {
    EXPECT_THAT(
        too_wide_pieces(set_of({sheet("A", 1.5, 3, "nylon"), sheet("B", 1.6, 2, "nylon"), sheet("C", 1.8, 4, "nylon"),
                                sheet("C2", 1.8, 0, "nylon"), sheet("D", 1.2, 1, "silk"), sheet("E", 0.9, 1, "silk")})),
        ElementsAre("6 of 9 pieces are wider across the warp than the roll of nylon, 1500 mm; the widest is C, "
                    "1800 mm. Divide them, turn their grain, or take a wider roll",
                    "1 of 2 pieces is wider across the warp than the roll of silk, 1000 mm; the widest is D, "
                    "1200 mm. Divide it, turn its grain, or take a wider roll"));
}

TEST(TooWidePieces, AreNoneWhereTheWidestIsAsWideAsTheRoll) {
    EXPECT_THAT(too_wide_pieces(set_of({sheet("A", 1.5, 3, "nylon")})), IsEmpty());
}

}  // namespace wide_pieces_test
}  // namespace ripstop
