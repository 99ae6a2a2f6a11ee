#include "ripstop/plan_folder/cut_files.h"

#include <gmock/gmock.h>

#include <limits>
#include <sstream>

#include "ripstop/base/error.h"
#include "ripstop/io/json/pieces_json.h"
#include "ripstop/pattern/piece/pieces.h"
#include "support/flat_tiles.h"
#include "support/outside.h"
#include "support/pattern_pieces.h"
#include "support/refusal.h"

namespace ripstop {
namespace cut_files_test {

using ::testing::HasSubstr;

PieceSet two_pieces() {
    const CutPlan plan = testing::two_tile_plan();
    return make_piece_set(plan, make_pieces(plan), "B");
}

TEST(PieceSet, NamesEachFabricAndSeamTypeOnce) {
    const PieceSet set = two_pieces();
    EXPECT_EQ(set.fabrics.size(), 1U);
    ASSERT_EQ(set.seam_types.size(), 1U);
    EXPECT_EQ(set.seam_types[0].name, default_hem().name);
    EXPECT_EQ(set.pieces[0].file, "G01_P01");
    EXPECT_EQ(set.pieces[0].revision, "");
}

TEST(PieceSet, ComesBackFromItsFileToTheLastBit) {
    PieceSet set = two_pieces();
    set.pieces[0].lines.push_back({"tape \"A\"", set.pieces[0].sew_line.topRows(2)});
    PieceNotch notch;
    notch.seam = "S001";
    notch.along = 1.0 / 3;
    notch.on_sew = set.pieces[0].sew_line.row(0);
    notch.count = 2;
    set.pieces[0].notches.push_back(notch);
    set.pieces[0].edges[0].mates.push_back({"S001", "H\xC3\xBClle", 0.1});
    const std::string text = pieces_json(set);
    std::istringstream in(text);
    const PieceSet again = read_pieces(in, "pieces.json");
    EXPECT_EQ(pieces_json(again), text);
    ASSERT_EQ(again.pieces.size(), 2U);
    EXPECT_EQ(again.pieces[0].cut_line, set.pieces[0].cut_line);
    EXPECT_EQ(again.pieces[0].edges[0].mates[0].piece, "H\xC3\xBClle");
    EXPECT_EQ(again.pieces[0].notches[0].along, 1.0 / 3);
}

std::string refusal(const PieceSet& set) {
    return testing::refusal([&] {
        std::istringstream in(pieces_json(set));
        read_pieces(in, "pieces.json");
    });
}

TEST(PieceSet, IsRefusedWhereItSaysWhatNoPieceHas) {
    const PieceSet sound = two_pieces();
    EXPECT_EQ(refusal(sound), "accepted");
    PieceSet set = sound;
    set.pieces[0].edges[0].allowance = -0.001;
    EXPECT_THAT(refusal(set), HasSubstr("pieces 1, edges 1: allowance_m is negative"));
    set = sound;
    set.pieces[1].notches.emplace_back();
    set.pieces[1].notches[0].outward = Vec2(2, 0);
    EXPECT_THAT(refusal(set), HasSubstr("outward is not a unit vector"));
    set = sound;
    set.pieces[1].pattern = "nobody";
    EXPECT_THAT(refusal(set), HasSubstr("no piece with a pattern of its own is called nobody"));
    set = sound;
    set.pieces[1].fabric = "silk";
    EXPECT_THAT(refusal(set), HasSubstr("no fabric is called silk"));
    set = sound;
    set.pieces[1].name = set.pieces[0].name;
    EXPECT_THAT(refusal(set), HasSubstr("two pieces are called G01 P01"));
}

TEST(PieceSet, WritesTheSameCutFilesAfterItWasRead) {
    const testing::ScratchDirectory scratch;
    const PieceSet set = two_pieces();
    write_cut_files(scratch.path("a"), set, {"dxf", "svg"});
    std::istringstream in(pieces_json(set));
    write_cut_files(scratch.path("b"), read_pieces(in, "pieces.json"), {"dxf", "svg"});
    for (const char* name : {"envelope.dxf", "envelope.svg", "tiles/G01_P01.dxf", "tiles/G01_P01.svg"})
        EXPECT_EQ(testing::content(scratch.path("a") + "/" + name), testing::content(scratch.path("b") + "/" + name));
}

Points2 rectangle(const Vec2& lower, const Vec2& size) {
    Points2 corners(4, 2);
    corners << lower.x(), lower.y(), lower.x() + size.x(), lower.y(), lower.x() + size.x(), lower.y() + size.y(),
        lower.x(), lower.y() + size.y();
    return corners;
}

TEST(LayOut, KeepsPiecesApartInOrderAndAsTheyAreTurned) {
    std::vector<PatternPiece> pieces;
    for (int i = 0; i < 30; ++i) {
        const double width = 0.2 + 0.13 * (i % 7), height = 0.1 + 0.07 * (i % 5);
        PatternPiece piece;
        piece.sew_line = rectangle({5, -3}, {width, height});
        pieces.push_back(piece);
    }
    pieces[4].sew_line.resize(0, 2);
    const double gap = 0.02;
    const std::vector<Vec2> shifts = lay_out(pieces, gap);
    ASSERT_EQ(shifts.size(), pieces.size());
    Vec2 lowest = Vec2::Constant(1e9), highest = Vec2::Constant(-1e9);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        if (i == 4) continue;
        const Vec2 lower = pieces[i].lower() + shifts[i], upper = pieces[i].upper() + shifts[i];
        lowest = lowest.cwiseMin(lower);
        highest = highest.cwiseMax(upper);
        for (std::size_t j = 0; j < i; ++j) {
            if (j == 4) continue;
            const Vec2 other_lower = pieces[j].lower() + shifts[j], other_upper = pieces[j].upper() + shifts[j];
            const double apart = std::max((lower - other_upper).maxCoeff(), (other_lower - upper).maxCoeff());
            EXPECT_GE(apart, gap - 1e-12) << i << " and " << j;
        }
    }
    EXPECT_NEAR(lowest.norm(), 0, 1e-12);
    EXPECT_LT((highest - lowest).maxCoeff(), 2 * (highest - lowest).minCoeff()) << "about square";
}

TEST(LayOut, IsAsLongAsItIsAskedToBe) {
    const std::vector<PatternPiece> pieces = testing::many_pieces(20);
    const std::vector<Vec2> row = lay_out(pieces, 0.02, std::numeric_limits<double>::infinity());
    const std::vector<Vec2> column = lay_out(pieces, 0.02, 0.1);
    for (std::size_t i = 1; i < pieces.size(); ++i) {
        EXPECT_EQ(row[i].y(), row[0].y());
        EXPECT_GT(row[i].x(), row[i - 1].x());
        EXPECT_EQ(column[i].x(), column[0].x());
        EXPECT_LT(column[i].y(), column[i - 1].y());
    }
}

TEST(LayOut, OfNothingIsNothing) {
    EXPECT_TRUE(lay_out({}, 0.02).empty());
}

}  // namespace cut_files_test
}  // namespace ripstop
