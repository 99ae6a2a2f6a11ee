#include "ripstop/base/text/glob.h"

#include <gtest/gtest.h>

#include <string>

namespace ripstop {
namespace glob_test {

TEST(Glob, MatchesTheWholeTextAndNothingLess) {
    EXPECT_TRUE(glob_match("G01P03", "G01P03"));
    EXPECT_FALSE(glob_match("G01", "G01P03"));
    EXPECT_FALSE(glob_match("P03", "G01P03"));
    EXPECT_FALSE(glob_match("g01p03", "G01P03"));
    EXPECT_TRUE(glob_match("", ""));
    EXPECT_FALSE(glob_match("", "G"));
    EXPECT_FALSE(glob_match("?", ""));
}

TEST(Glob, StarStandsForAnyRun) {
    EXPECT_TRUE(glob_match("*", ""));
    EXPECT_TRUE(glob_match("**", "G01"));
    EXPECT_TRUE(glob_match("G*P03", "G01P03"));
    EXPECT_TRUE(glob_match("G*P03", "GP03"));
    EXPECT_TRUE(glob_match("*03", "G03P03"));
    EXPECT_TRUE(glob_match("hull*left", "hull/side/left"));
    EXPECT_FALSE(glob_match("G*P03", "G01P04"));
    EXPECT_FALSE(glob_match("*a*b*", "bbba"));
}

TEST(Glob, QuestionMarkStandsForOneCharacterOfUtf8) {
    EXPECT_TRUE(glob_match("G??P*", "G01P03"));
    EXPECT_FALSE(glob_match("G??P*", "G1P03"));
    EXPECT_TRUE(glob_match("H?lle", "H\xC3\xBClle"));
    EXPECT_FALSE(glob_match("H??lle", "H\xC3\xBClle"));
    EXPECT_TRUE(glob_match("*?lle", "H\xC3\xBClle"));
}

TEST(Glob, ManyStarsOnALongTextEndAtOnce) {
    std::string pattern;
    for (int i = 0; i < 50; ++i) pattern += "*a";
    EXPECT_FALSE(glob_match(pattern + "b", std::string(20000, 'a')));
    EXPECT_TRUE(glob_match(pattern, std::string(20000, 'a')));
}

}  // namespace glob_test
}  // namespace ripstop
