#include "ripstop/geometry/polygon.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <chrono>
#include <cmath>
#include <numbers>
#include <random>

namespace ripstop {
namespace polygon_test {

Points2 polygon(std::initializer_list<std::array<double, 2>> corners) {
    Points2 result(static_cast<Eigen::Index>(corners.size()), 2);
    Eigen::Index i = 0;
    for (const auto& corner : corners) result.row(i++) << corner[0], corner[1];
    return result;
}

const Points2 l_shape = polygon({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}});

/// A band of constant width in `turns` windings: long, curled, without crossings.
Points2 spiral(double turns, int points_a_side) {
    Points2 result(2 * points_a_side, 2);
    for (int i = 0; i < points_a_side; ++i) {
        const double angle = 2 * std::numbers::pi * turns * i / (points_a_side - 1);
        const double radius = 1 + 0.5 * angle / (2 * std::numbers::pi);
        const Vec2 along(std::cos(angle), std::sin(angle));
        result.row(i) = ((radius + 0.2) * along).transpose();
        result.row(2 * points_a_side - 1 - i) = (radius * along).transpose();
    }
    return result;
}

TEST(Polygon, HasTheAreaAndPerimeterOfAnL) {
    EXPECT_DOUBLE_EQ(signed_area(l_shape), 5);
    EXPECT_DOUBLE_EQ(signed_area(l_shape.colwise().reverse()), -5);
    EXPECT_DOUBLE_EQ(perimeter(l_shape), 12);
    const Points2 far = l_shape.rowwise() + Eigen::RowVector2d(1e6, -1e6);
    EXPECT_DOUBLE_EQ(signed_area(far), 5);
}

TEST(Polygon, ContainsWhatLiesInsideAnL) {
    EXPECT_TRUE(contains(l_shape, Vec2(0.5, 2.5)));
    EXPECT_TRUE(contains(l_shape, Vec2(2.5, 0.5)));
    EXPECT_FALSE(contains(l_shape, Vec2(2, 2)));
    EXPECT_FALSE(contains(l_shape, Vec2(-0.1, 1)));
    EXPECT_FALSE(contains(l_shape, Vec2(5, 0)));
    EXPECT_DOUBLE_EQ(distance_to_outline(l_shape, Vec2(2, 2)), 1);
    EXPECT_DOUBLE_EQ(distance_to_outline(l_shape, Vec2(0.5, 0.25)), 0.25);
}

TEST(Polygon, ContainsABoxOnlyAsAWhole) {
    EXPECT_TRUE(contains(l_shape, Box{{1.5, 0.5}, {1.4, 0.4}, 0}));
    EXPECT_FALSE(contains(l_shape, Box{{1.5, 0.5}, {1.6, 0.4}, 0}));
    EXPECT_FALSE(contains(l_shape, Box{{1.5, 0.5}, {0.4, 1.4}, 0}));
    EXPECT_TRUE(contains(l_shape, Box{{1.5, 0.5}, {0.4, 1.4}, std::numbers::pi / 2}));
    EXPECT_FALSE(contains(l_shape, Box{{1.2, 1.2}, {0.4, 0.1}, 0})) << "its corners reach past the inner corner";
    EXPECT_FALSE(contains(l_shape, Box{{0.5, 0.5}, {10, 10}, 0})) << "a box around the polygon";
}

TEST(Polygon, HasTheChordsOfAnL) {
    ASSERT_EQ(horizontal_chords(l_shape, 0.5).size(), 1u);
    EXPECT_EQ(horizontal_chords(l_shape, 0.5)[0], (std::array<double, 2>{0, 3}));
    EXPECT_EQ(horizontal_chords(l_shape, 2)[0], (std::array<double, 2>{0, 1}));
    EXPECT_TRUE(horizontal_chords(l_shape, 4).empty());
    const Points2 u = polygon({{0, 0}, {3, 0}, {3, 2}, {2, 2}, {2, 1}, {1, 1}, {1, 2}, {0, 2}});
    EXPECT_EQ(horizontal_chords(u, 1.5).size(), 2u);
}

TEST(LargestCircleInside, OfARectangleIsAsWideAsIt) {
    const Circle circle = largest_circle_inside(polygon({{0, 0}, {5, 0}, {5, 2}, {0, 2}}), 1e-3);
    EXPECT_NEAR(circle.radius, 1, 1e-3);
    EXPECT_NEAR(circle.centre.y(), 1, 1e-3);
}

TEST(LargestCircleInside, OfAnLSitsInTheCorner) {
    // The circle touches both outer sides and the inner corner (1, 1): r + r / sqrt 2 = 1 along the diagonal.
    const Circle circle = largest_circle_inside(l_shape, 1e-4);
    EXPECT_NEAR(circle.radius, std::sqrt(2) / (1 + std::sqrt(2)), 1e-4);
}

TEST(LargestCircleInside, OfAThinOrEmptyPolygonDoesNotRunAway) {
    EXPECT_NEAR(largest_circle_inside(polygon({{0, 0}, {100, 0}, {100, 0.1}, {0, 0.1}}), 5e-3).radius, 0.05, 5e-3);
    EXPECT_EQ(largest_circle_inside(polygon({{0, 0}, {1, 0}, {2, 0}}), 1e-3).radius, 0);
    EXPECT_EQ(largest_circle_inside(polygon({{1, 1}, {1, 1}, {1, 1}}), 1e-3).radius, 0);
}

TEST(SelfIntersections, NoneInSimpleOutlines) {
    EXPECT_EQ(self_intersections(l_shape).count, 0);
    EXPECT_EQ(self_intersections(spiral(3, 400)).count, 0);
    EXPECT_EQ(self_intersections(polygon({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {0, 1}})).count, 0) << "straight corner";
    EXPECT_EQ(self_intersections(polygon({{0, 0}, {1, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}})).count, 0) << "repeated";
}

TEST(SelfIntersections, FindsTheCrossingOfAnEight) {
    const SelfIntersections found = self_intersections(polygon({{0, 0}, {2, 2}, {2, 0}, {0, 2}}));
    EXPECT_EQ(found.count, 1);
    EXPECT_NEAR((found.first - Vec2(1, 1)).norm(), 0, 1e-12);
}

TEST(SelfIntersections, CountsAnOverlapOfTwoArmsAsTwoCrossings) {
    // One finger of the outline is pushed across the opposite side.
    const Points2 pushed = polygon({{0, 0}, {4, 0}, {4, 1}, {2.5, 1}, {2, -1}, {1.5, 1}, {0, 1}});
    const SelfIntersections found = self_intersections(pushed);
    EXPECT_EQ(found.count, 2);
    EXPECT_NEAR(found.first.y(), 0, 1e-12);
}

TEST(SelfIntersections, CountsATouchOnceAndAFoldWithTheCornerItLeaves) {
    EXPECT_EQ(self_intersections(polygon({{0, 0}, {4, 0}, {4, 1}, {2, 0}, {0, 1}})).count, 1) << "corner on an edge";
    EXPECT_EQ(self_intersections(polygon({{0, 0}, {1, 1}, {2, 0}, {2, 2}, {1, 1}, {0, 2}})).count, 1)
        << "corner on corner";
    const SelfIntersections spike = self_intersections(polygon({{0, 0}, {4, 0}, {3, 0}, {3, 2}, {0, 2}}));
    EXPECT_EQ(spike.count, 2) << "the fold at (4, 0) and the corner (3, 0) on the first edge";
    EXPECT_EQ(spike.first, Vec2(4, 0));
}

TEST(SelfIntersections, AreFastForThreeThousandCornersEvenAllAcross) {
    // A comb whose teeth are as long as the whole: the spans of all edges overlap.
    Points2 comb(3000, 2);
    for (int i = 0; i < 2999; ++i) comb.row(i) << (i % 2 == 0 ? 0.0 : 1.0), 1e-4 * i;
    comb.row(2999) << -1, 0.15;
    const auto start = std::chrono::steady_clock::now();
    EXPECT_EQ(self_intersections(comb).count, 0);
    EXPECT_EQ(self_intersections(spiral(20, 1500)).count, 0);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    EXPECT_LT(seconds.count(), 2.0) << "tens of milliseconds when optimised; a cubic algorithm takes minutes";
}

TEST(SelfIntersections, AgreeWithTryingAllPairsOnRandomPolygons) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform(0, 1);
    for (int n = 0; n < 200; ++n) {
        Points2 points(12, 2);
        for (int i = 0; i < 12; ++i) points.row(i) << uniform(random), uniform(random);
        int expected = 0;
        for (int i = 0; i < 12; ++i)
            for (int j = i + 2; j < 12; ++j) {
                if (i == 0 && j == 11) continue;
                const Vec2 a = points.row(i), b = points.row((i + 1) % 12), c = points.row(j),
                           d = points.row((j + 1) % 12);
                Eigen::Matrix2d m;
                m << b - a, c - d;
                const Vec2 t = m.inverse() * (c - a);
                expected += (t.array() > 0).all() && (t.array() < 1).all();
            }
        ASSERT_EQ(self_intersections(points).count, expected) << n;
    }
}

}  // namespace polygon_test
}  // namespace ripstop
