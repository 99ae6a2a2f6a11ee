#include "ripstop/geometry/join_lines.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "ripstop/geometry/corners.h"

namespace ripstop {
namespace join_lines_test {

Points2 line(const Vec2& a, const Vec2& b) {
    Points2 points(2, 2);
    points << a.transpose(), b.transpose();
    return points;
}

TEST(JoinLines, ClosesAShuffledPolygonWhicheverWayItsEdgesRun) {
    std::mt19937 random(7);
    const int count = 200;
    std::vector<Points2> edges;
    const auto corner = [](int i) {
        const double angle = 2 * M_PI * i / count;
        return Vec2(std::cos(angle), 2 * std::sin(angle));
    };
    for (int i = 0; i < count; ++i)
        edges.push_back(random() % 2 ? line(corner(i), corner((i + 1) % count))
                                     : line(corner((i + 1) % count), corner(i)));
    std::shuffle(edges.begin(), edges.end(), random);
    const std::vector<JoinedLine> joined = join_lines(edges, 1e-9);
    ASSERT_EQ(joined.size(), 1U);
    EXPECT_TRUE(joined[0].is_closed);
    EXPECT_EQ(joined[0].points.rows(), count);
    EXPECT_EQ(joined[0].lines.size(), edges.size());
}

TEST(JoinLines, KeepsLinesApartThatAreFurtherThanTheTolerance) {
    const std::vector<Points2> lines{line({0, 0}, {1, 0}), line({1.02, 0}, {2, 0}), line({1, 0.005}, {1, 1})};
    const std::vector<JoinedLine> joined = join_lines(lines, 0.01);
    ASSERT_EQ(joined.size(), 2U);
    EXPECT_EQ(joined[0].lines, (std::vector<int>{0, 2}));
    EXPECT_FALSE(joined[0].is_closed);
    EXPECT_EQ(joined[0].points.rows(), 3);
    EXPECT_EQ(joined[1].lines, (std::vector<int>{1}));
}

TEST(JoinLines, GoesOnBothWaysFromWhereItBegins) {
    const std::vector<JoinedLine> joined =
        join_lines({line({1, 0}, {2, 0}), line({2, 0}, {3, 0}), line({0, 0}, {1, 0})}, 1e-6);
    ASSERT_EQ(joined.size(), 1U);
    EXPECT_EQ(joined[0].points.col(0), Eigen::Vector4d(0, 1, 2, 3));
}

TEST(JoinLines, ClosesAnOutlineThoughLinesThatEndComeFirst) {
    const Vec2 a(0, 0), b(1, 0), c(1, 1);
    const std::vector<JoinedLine> joined =
        join_lines({line(a, {0.1, 0.1}), line(b, {0.9, 0.1}), line(a, b), line(b, c), line(c, a)}, 1e-6);
    ASSERT_EQ(joined.size(), 3U);
    EXPECT_TRUE(joined[2].is_closed);
    EXPECT_EQ(joined[2].points.rows(), 3);
    EXPECT_EQ(joined[0].lines, (std::vector<int>{0}));
    EXPECT_EQ(joined[1].lines, (std::vector<int>{1}));
}

TEST(JoinLines, TakesASingleLineThatEndsWhereItBeginsForClosed) {
    Points2 ring(4, 2);
    ring << 0, 0, 1, 0, 1, 1, 0, 0;
    const std::vector<JoinedLine> joined = join_lines({ring, Points2(0, 2)}, 1e-6);
    EXPECT_TRUE(joined[0].is_closed);
    EXPECT_EQ(joined[0].points.rows(), 3);
    EXPECT_FALSE(joined[1].is_closed);
}

TEST(JoinLines, DoesNotCloseAStraightLineShorterThanTheTolerance) {
    const std::vector<JoinedLine> joined = join_lines({line({0, 0}, {0.001, 0})}, 0.01);
    EXPECT_FALSE(joined.at(0).is_closed);
    EXPECT_EQ(joined[0].points.rows(), 2);
}

TEST(SharpCorners, AreWhereAPolygonTurns) {
    Points2 polygon(6, 2);
    polygon << 0, 0, 0.5, 0.001, 1, 0, 1, 0, 1, 1, 0, 1;
    EXPECT_EQ(sharp_corners(polygon, 0.2), (std::vector<int>{0, 2, 4, 5}));
    EXPECT_EQ(sharp_corners(polygon, 1e-3), (std::vector<int>{0, 1, 2, 4, 5}));
    EXPECT_TRUE(sharp_corners(polygon, 2).empty());
    EXPECT_TRUE(sharp_corners(Points2(0, 2), 1).empty());
}

}  // namespace join_lines_test
}  // namespace ripstop
