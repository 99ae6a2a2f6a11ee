#include "ripstop/assembly/faults/judge_unit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace ripstop {
namespace judge_unit_test {

using ::testing::HasSubstr;
using ::testing::Not;

std::vector<Eigen::AlignedBox3d> box(double size) {
    return {Eigen::AlignedBox3d(Vec3(0, 0, 0), Vec3(size, size, size / 10))};
}

UnitRead read_in(const std::string& unit) {
    return {{unit, metres_per_unit(unit)}};
}

/// The message for an envelope that measures `numbers` in the file, read in `unit`.
std::string said(double numbers, const std::string& unit) {
    const auto doubt = doubt_unit(box(numbers * metres_per_unit(unit)), read_in(unit));
    return doubt ? (doubt->is_wrong ? "wrong: " : "note: ") + doubt->sentence : "";
}

TEST(Unit, IsTakenWhereTheSizeIsOneThatIsSewn) {
    for (const double metres : {0.12, 0.3, 1.0, 2.5, 12.0, 35.0, 60.0})
        for (const char* unit : {"mm", "cm", "m"}) EXPECT_EQ(said(metres / metres_per_unit(unit), unit), "") << metres;
    EXPECT_EQ(said(0.02, "m"), "") << "no other unit makes more of it";
}

TEST(Unit, IsCentimetresBeforeInches) {
    const std::string sheet = said(300, "m");
    EXPECT_THAT(sheet, HasSubstr("wrong: the envelope measures 300 m, a hot-air balloon is 5 to 60 m tall; "
                                 "with --unit cm it would measure 3.00 m, with in 7.62 m; give --size-is-meant"));
    EXPECT_THAT(said(2000, "m"), HasSubstr("with --unit cm it would measure 20.00 m"));
    EXPECT_THAT(said(20000, "m"), HasSubstr("with --unit mm it would measure 20.00 m"));
    EXPECT_THAT(said(20000, "cm"), HasSubstr("with --unit mm it would measure 20.00 m"));
    EXPECT_THAT(said(20, "mm"), HasSubstr("with --unit m it would measure 20.00 m"));
    EXPECT_THAT(said(9, "cm"), HasSubstr("with --unit m it would measure 9.00 m"));
}

TEST(Unit, IsWrongBeyondAnyBalloonThoughNoOtherFits) {
    EXPECT_THAT(said(1e7, "m"), HasSubstr("wrong: the envelope measures 10000000 m"));
    EXPECT_THAT(said(1e7, "m"), HasSubstr("check the unit"));
}

TEST(Unit, IsWorthALookWhereFeetWouldGiveABalloon) {
    EXPECT_THAT(said(70, "m"), HasSubstr("note: the envelope measures 70 m"));
    EXPECT_THAT(said(70, "m"), HasSubstr("21.34 m"));
    // a balloon of 20 m in centimetres: gores of a few centimetres
    std::vector<Eigen::AlignedBox3d> panels;
    for (int i = 0; i < 100; ++i) panels.emplace_back(Vec3(0, 0, 0.002 * i), Vec3(0.012, 0.013, 0.002 * i + 0.012));
    const auto doubt = doubt_unit(panels, read_in("cm"));
    ASSERT_TRUE(doubt);
    EXPECT_FALSE(doubt->is_wrong);
    EXPECT_THAT(doubt->sentence, HasSubstr("half of its tiles are below 50 mm, twice a seam allowance of an inch; "
                                           "with --unit m it would measure 21.00 m"));
}

TEST(Unit, IsNotDoubtedWhereTheSizeIsMeant) {
    UnitRead read = read_in("m");
    read.size_is_meant = true;
    EXPECT_FALSE(doubt_unit(box(300), read));
}

TEST(Unit, OfTheFileItselfIsNamedAsSuch) {
    UnitRead read = read_in("m");
    EXPECT_THAT(doubt_unit(box(300), read)->sentence, Not(HasSubstr("the file's own unit")));
    read.is_files = true;
    EXPECT_THAT(doubt_unit(box(300), read)->sentence, HasSubstr("300 m in the file's own unit, m, a hot-air"));
}

TEST(Unit, IsNotDoubtedForOneTileGoneAstray) {
    std::vector<Eigen::AlignedBox3d> tiles;
    for (int i = 0; i < 60; ++i) tiles.emplace_back(Vec3(0, 0, 0.2 * i), Vec3(1, 1, 0.2 * i + 1));
    tiles.emplace_back(Vec3(0, 0, 5000), Vec3(1, 1, 5001));
    EXPECT_FALSE(doubt_unit(tiles, read_in("m")));
}

}  // namespace judge_unit_test
}  // namespace ripstop
