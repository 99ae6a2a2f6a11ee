#include "ripstop/geometry/clip.h"

#include <gtest/gtest.h>

namespace ripstop {
namespace clip_test {

Points2 polyline(const std::vector<Vec2>& points) {
    Points2 rows(static_cast<Eigen::Index>(points.size()), 2);
    for (std::size_t i = 0; i < points.size(); ++i) rows.row(static_cast<Eigen::Index>(i)) = points[i].transpose();
    return rows;
}

double length(const Points2& line) {
    double sum = 0;
    for (Eigen::Index i = 0; i + 1 < line.rows(); ++i) sum += (line.row(i + 1) - line.row(i)).norm();
    return sum;
}

TEST(Clip, KeepsALineInsideAsItIs) {
    const Points2 line = polyline({{1, 1}, {2, 3}, {4, 1}});
    const auto parts = clip_to_box(line, {0, 0}, {4, 4});
    ASSERT_EQ(parts.size(), 1U);
    EXPECT_EQ(parts[0].points, line);
    EXPECT_EQ(parts[0].from, 0);
}

TEST(Clip, CutsALineWhereItLeavesAndComesBack) {
    const auto parts = clip_to_box(polyline({{-1, 1}, {1, 1}, {1, 5}, {3, 5}, {3, 1}}), {0, 0}, {4, 4});
    ASSERT_EQ(parts.size(), 2U);
    EXPECT_EQ(parts[0].points, polyline({{0, 1}, {1, 1}, {1, 4}}));
    EXPECT_EQ(parts[0].from, 1);
    EXPECT_EQ(parts[1].points, polyline({{3, 4}, {3, 1}}));
    EXPECT_EQ(parts[1].from, 2 + 4 + 2 + 1);
}

TEST(Clip, LeavesOutWhatIsOutsideOrOnlyTouches) {
    EXPECT_TRUE(clip_to_box(polyline({{5, 0}, {5, 4}}), {0, 0}, {4, 4}).empty());
    EXPECT_TRUE(clip_to_box(polyline({{3, 5}, {5, 3}}), {0, 0}, {4, 4}).empty());
    EXPECT_TRUE(clip_to_box(polyline({{2, 2}, {2, 2}}), {0, 0}, {4, 4}).empty());
    EXPECT_TRUE(clip_to_box(Points2(0, 2), {0, 0}, {4, 4}).empty());
}

TEST(Clip, BoxesSideBySideCutAtTheSamePointAndLoseNothing) {
    const Points2 line = polyline({{0.1, 0.2}, {1.7, 3.9}, {2.9, 0.3}, {0.4, 3.1}});
    double sum = 0;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            for (const LinePart& part : clip_to_box(line, Vec2(i, j), Vec2(i + 1, j + 1))) sum += length(part.points);
    EXPECT_NEAR(sum, length(line), 1e-12 * length(line)) << "sums of sixteen parts, rounded";
    const auto left = clip_to_box(line, {0, 0}, {1, 4}), right = clip_to_box(line, {1, 0}, {4, 4});
    EXPECT_EQ(left[0].points.row(1), right[0].points.row(0));
    EXPECT_EQ(left[0].points(1, 0), 1);
}

TEST(Clip, ClosesAPolygon) {
    EXPECT_EQ(closed_line(polyline({{0, 0}, {1, 0}, {0, 1}})), polyline({{0, 0}, {1, 0}, {0, 1}, {0, 0}}));
    EXPECT_EQ(closed_line(Points2(0, 2)).rows(), 0);
}

}  // namespace clip_test
}  // namespace ripstop
