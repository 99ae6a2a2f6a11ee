#include "ripstop/mesh/change/delaunay.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "ripstop/geometry/polygon.h"
#include "ripstop/geometry/triangle.h"

namespace ripstop {
namespace delaunay_test {

/// A circle of `outline` points with others inside, at least `apart` from it.
Points2 round_cloud(int outline, int inside, double apart, unsigned seed) {
    std::mt19937 random(seed);
    const auto uniform = [&] { return 2 * (static_cast<double>(random()) / 4294967295.0) - 1; };
    Points2 points(outline + inside, 2);
    for (int i = 0; i < outline; ++i)
        points.row(i) << std::cos(2 * std::numbers::pi * i / outline), std::sin(2 * std::numbers::pi * i / outline);
    for (int i = outline; i < outline + inside;) {
        const Vec2 point(uniform(), uniform());
        if (point.norm() < 1 - apart) points.row(i++) = point;
    }
    return points;
}

Vec2 at(const Points2& points, int i) {
    return points.row(i);
}

double area_of(const Points2& points, const Triangles& triangles) {
    double area = 0;
    for (int t = 0; t < triangles.rows(); ++t) {
        const double one =
            signed_area(at(points, triangles(t, 0)), at(points, triangles(t, 1)), at(points, triangles(t, 2)));
        EXPECT_GT(one, -1e-9);
        area += one;
    }
    return area;
}

TEST(DelaunayInside, CoversTheOutlineAndNoCircleHoldsAPoint) {
    for (const unsigned seed : {1u, 2u, 3u}) {
        const Points2 points = round_cloud(40, 120, 0.1, seed);
        const Triangles triangles = delaunay_inside(points, 40);
        EXPECT_EQ(triangles.rows(), 2 * 160 - 40 - 2);
        EXPECT_NEAR(area_of(points, triangles), signed_area(Points2(points.topRows(40))), 1e-9);
        for (int t = 0; t < triangles.rows(); ++t) {
            const Vec2 a = at(points, triangles(t, 0)), u = at(points, triangles(t, 1)) - a,
                       v = at(points, triangles(t, 2)) - a;
            const Vec2 centre = a + Vec2(v.y() * u.squaredNorm() - u.y() * v.squaredNorm(),
                                         u.x() * v.squaredNorm() - v.x() * u.squaredNorm()) /
                                        (2 * cross(u, v));
            const double radius = (a - centre).norm();
            for (int i = 0; i < points.rows(); ++i) EXPECT_GT((at(points, i) - centre).norm(), radius * (1 - 1e-6));
        }
    }
}

TEST(DelaunayInside, TakesSquaresWhoseCornersLieOnOneCircle) {
    Points2 points(8 * 8, 2);
    int next = 0;
    const auto add = [&](int i, int j) { points.row(next++) << i, j; };
    for (int i = 0; i < 7; ++i) add(i, 0);
    for (int j = 0; j < 7; ++j) add(7, j);
    for (int i = 7; i > 0; --i) add(i, 7);
    for (int j = 7; j > 0; --j) add(0, j);
    for (int j = 1; j < 7; ++j)
        for (int i = 1; i < 7; ++i) add(i, j);
    const Triangles triangles = delaunay_inside(points, 28);
    EXPECT_EQ(triangles.rows(), 2 * 49);
    EXPECT_NEAR(area_of(points, triangles), 49, 1e-9);
}

TEST(DelaunayInside, GivesNothingWhereAnEdgeOfTheOutlineIsMissing) {
    Points2 points(5, 2);
    points << 0, 0, 4, 0, 4, 4, 0, 4, 2, 0.01;
    EXPECT_EQ(delaunay_inside(points, 4).rows(), 4);
    Points2 crossed(6, 2);
    crossed << 0, 0, 4, 0, 4, 4, 2, 0.5, 0, 4, 2, -0.4;  // the last point makes the outline cross itself
    EXPECT_EQ(delaunay_inside(crossed, 5).rows(), 0);
}

}  // namespace delaunay_test
}  // namespace ripstop
