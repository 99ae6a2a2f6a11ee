#include "ripstop/mesh/fan.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ripstop {
namespace fan_test {

std::vector<Vec3> polygon(std::initializer_list<Vec2> points) {
    std::vector<Vec3> result;
    for (const Vec2& p : points) result.emplace_back(p.x(), p.y(), 0.3 * p.x());
    return result;
}

TEST(Fan, StartsAtTheFirstCornerOfAConvexPolygon) {
    EXPECT_EQ(fan_corner(polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}})), 0);
    EXPECT_EQ(fan_corner(polygon({{0, 1}, {1, 1}, {1, 0}, {0, 0}})), 0);
    std::vector<Vec3> circle;
    for (int i = 0; i < 500; ++i) circle.emplace_back(std::cos(i * 0.01), std::sin(i * 0.01), 1);
    EXPECT_EQ(fan_corner(circle), 0);
}

TEST(Fan, StartsWhereANotchCanBeSeenFrom) {
    // an arrowhead: a fan stays inside only from the reflex corner and from the tip opposite
    EXPECT_EQ(fan_corner(polygon({{2, 0}, {0, 1}, {1, 0}, {0, -1}})), 0);
    EXPECT_EQ(fan_corner(polygon({{0, 1}, {1, 0}, {0, -1}, {2, 0}})), 1);
}

TEST(Fan, AvoidsTrianglesWithoutAreaAtACornerOnAStraightSide) {
    EXPECT_EQ(fan_corner(polygon({{0, 0}, {1, 0}, {2, 0}, {0, 1}})), 1);
}

TEST(Fan, RefusesAPolygonThatEveryFanFoldsOver) {
    EXPECT_EQ(fan_corner(polygon({{0, 0}, {1, 1}, {1, 0}, {0, 1}})), -1) << "bow tie";
    EXPECT_EQ(fan_corner({{0, 0, 0}, {1, 1, 0.1}, {1, 0, 0}, {0, 1, 0}}), -1) << "bow tie out of its plane";
    EXPECT_GE(fan_corner({{0, 0, 0}, {1, 0, 0}, {1, 1, 0.6}, {0, 1, 0}}), 0)
        << "a quad bent by less than a right angle";
    EXPECT_EQ(fan_corner(polygon(
                  {{0, 0}, {9, 0}, {9, 9}, {8, 9}, {8, 1}, {5, 1}, {5, 5}, {4, 5}, {4, 1}, {1, 1}, {1, 9}, {0, 9}})),
              -1)
        << "comb";
    EXPECT_EQ(fan_corner(polygon({{0, 0}, {1, 0}, {2, 0}, {3, 0}})), -1) << "straight line";
}

}  // namespace fan_test
}  // namespace ripstop
