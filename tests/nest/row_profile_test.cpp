#include "ripstop/nest/row_profile.h"

#include <gtest/gtest.h>

namespace ripstop {
namespace row_profile_test {

Points2 points(std::initializer_list<Vec2> corners) {
    Points2 result(static_cast<Eigen::Index>(corners.size()), 2);
    Eigen::Index i = 0;
    for (const Vec2& corner : corners) result.row(i++) = corner.transpose();
    return result;
}

/// Two legs of 1 x 2 with a beam of 1 above them: open at the bottom, from 1 to 2.
Points2 gate() {
    return points({{0, 0}, {1, 0}, {1, 2}, {2, 2}, {2, 0}, {3, 0}, {3, 3}, {0, 3}});
}

TEST(RowProfile, CoversWhatTheOutlineCoversWithinEachRow) {
    const RowProfile profile = make_row_profile(points({{0, 0}, {2, 0}, {1, 1}}), 0, 0.25);
    ASSERT_EQ(profile.rows(), 4);
    EXPECT_TRUE(profile.divided.empty());
    for (int row = 0; row < 4; ++row) {
        EXPECT_NEAR(profile.lower[row], 0.25 * row, 1e-12);
        EXPECT_NEAR(profile.upper[row], 2 - 0.25 * row, 1e-12);
    }
}

TEST(RowProfile, HasEmptyRowsBelowTheOutline) {
    const RowProfile profile = make_row_profile(points({{0, 0}, {1, 0}, {1, 1}, {0, 1}}), -1, 0.5);
    ASSERT_EQ(profile.rows(), 4);
    EXPECT_GT(profile.lower[0], profile.upper[0]);
    EXPECT_EQ(profile.lower[2], 0);
    EXPECT_EQ(profile.upper[2], 1);
}

TEST(RowProfile, DividesRowsBesideAHollow) {
    const RowProfile profile = make_row_profile(gate(), 0, 0.5);
    EXPECT_EQ(profile.divided, (std::vector<int>{0, 1, 2, 3}));
    EXPECT_EQ(profile.first[1] - profile.first[0], 2);
}

TEST(OverlappingShifts, OfTwoSquaresAreOneSide) {
    const RowProfile square = make_row_profile(points({{0, 0}, {1, 0}, {1, 1}, {0, 1}}), 0, 0.25);
    std::vector<Interval> shifts;
    for (const int rows : {-3, 0, 3}) {
        find_overlapping_shifts(square, square, rows, shifts);
        ASSERT_EQ(shifts.size(), 1u);
        EXPECT_EQ(shifts[0].lower, -1);
        EXPECT_EQ(shifts[0].upper, 1);
    }
    for (const int rows : {-4, 4}) {
        find_overlapping_shifts(square, square, rows, shifts);
        EXPECT_TRUE(shifts.empty());
    }
}

TEST(OverlappingShifts, LeaveRoomInAHollow) {
    const RowProfile outer = make_row_profile(gate(), 0, 0.5);
    const RowProfile inner = make_row_profile(points({{0, 0}, {0.6, 0}, {0.6, 1.5}, {0, 1.5}}), 0, 0.5);
    std::vector<Interval> shifts;
    find_overlapping_shifts(outer, inner, 0, shifts);
    ASSERT_EQ(shifts.size(), 2u);  // between them, 1 to 1.4 is free
    EXPECT_NEAR(shifts[0].lower, -0.6, 1e-12);
    EXPECT_NEAR(shifts[0].upper, 1, 1e-12);
    EXPECT_NEAR(shifts[1].lower, 1.4, 1e-12);
    EXPECT_NEAR(shifts[1].upper, 3, 1e-12);
    find_overlapping_shifts(outer, inner, 2, shifts);  // into the beam
    ASSERT_EQ(shifts.size(), 1u);
}

}  // namespace row_profile_test
}  // namespace ripstop
