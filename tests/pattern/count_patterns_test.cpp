#include "ripstop/pattern/piece/count_patterns.h"

#include <gtest/gtest.h>

#include "ripstop/model/piece/pattern_piece.h"

namespace ripstop {
namespace pattern_piece_test {

/// A is the pattern of B, and mirrored of C and D; E is its own.
std::vector<PatternPiece> five_pieces() {
    const std::string names("ABCDE"), first("A"), count("cut 2 + 2 mirrored");
    std::vector<PatternPiece> pieces(names.size());
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        pieces[i].name = names.substr(i, 1);
        pieces[i].labels.emplace_back().text = pieces[i].name;
        pieces[i].quantity = 0;
        pieces[i].pattern = first;
    }
    pieces[0].quantity = pieces[0].quantity_mirrored = 2;
    Label& label = pieces[0].labels.emplace_back();
    label.text = count;
    label.counts = true;
    pieces[2].mirrored = pieces[3].mirrored = true;
    pieces[4].quantity = 1;
    pieces[0].pattern.clear();
    pieces[4].pattern.clear();
    return pieces;
}

TEST(CountPatterns, LeavesAllThePiecesAsTheyAre) {
    std::vector<PatternPiece> pieces = five_pieces();
    count_patterns(pieces);
    const std::vector<PatternPiece> before = five_pieces();
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        EXPECT_EQ(pieces[i].quantity, before[i].quantity);
        EXPECT_EQ(pieces[i].quantity_mirrored, before[i].quantity_mirrored);
        EXPECT_EQ(pieces[i].pattern, before[i].pattern);
        EXPECT_EQ(pieces[i].mirrored, before[i].mirrored);
    }
    EXPECT_EQ(pieces[0].labels.at(1).text, "cut 2 + 2 mirrored");
}

TEST(CountPatterns, MakesTheFirstOfThePiecesThatAreLeftThePattern) {
    std::vector<PatternPiece> pieces = five_pieces();
    pieces.erase(pieces.begin());
    std::swap(pieces[0], pieces[1]);  // C, B, D, E
    count_patterns(pieces);
    EXPECT_EQ(pieces[0].quantity, 2) << "C and D are alike";
    EXPECT_EQ(pieces[0].quantity_mirrored, 1);
    EXPECT_EQ(pieces[0].pattern, "");
    EXPECT_FALSE(pieces[0].mirrored);
    EXPECT_EQ(pieces[1].pattern, "C");
    EXPECT_TRUE(pieces[1].mirrored);
    EXPECT_EQ(pieces[1].quantity + pieces[1].quantity_mirrored, 0);
    EXPECT_EQ(pieces[2].pattern, "C");
    EXPECT_FALSE(pieces[2].mirrored);
    EXPECT_EQ(pieces[3].quantity, 1);
}

TEST(CountPatterns, RenewsTheCountThatIsWrittenOnAPieceOrDropsIt) {
    std::vector<PatternPiece> two = five_pieces();
    two.resize(2);
    count_patterns(two);
    ASSERT_EQ(two[0].labels.size(), 2U);
    EXPECT_EQ(two[0].labels[1].text, "cut 2");
    two.resize(1);
    count_patterns(two);
    ASSERT_EQ(two[0].labels.size(), 1U) << "what is cut once does not say so";
    EXPECT_EQ(two[0].labels[0].text, "A");
}

}  // namespace pattern_piece_test
}  // namespace ripstop
