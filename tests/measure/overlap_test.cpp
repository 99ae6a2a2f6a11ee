#include "ripstop/measure/overlap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "ripstop/geometry/triangle.h"
#include "support/shapes.h"

namespace ripstop {
namespace overlap_test {

TEST(OverlappingTriangles, AFlatGridHasNone) {
    const TriangleMesh mesh = testing::rectangle(3, 2, 30, 20);
    EXPECT_TRUE(overlapping_triangles(mesh.triangles, mesh.positions.leftCols(2)).empty());
}

TEST(OverlappingTriangles, TurningAGridByAnyAngleMakesNone) {
    const TriangleMesh mesh = testing::rectangle(3, 2, 12, 9);
    for (int i = 0; i < 50; ++i) {
        const double a = 0.13 * i;
        Mat22 turn;
        turn << std::cos(a), -std::sin(a), std::sin(a), std::cos(a);
        EXPECT_TRUE(overlapping_triangles(mesh.triangles, mesh.positions.leftCols(2) * turn.transpose()).empty()) << a;
    }
}

TEST(OverlappingTriangles, AStripWoundOnceAndAHalfLiesOnItself) {
    const int n = 60;
    const TriangleMesh mesh = testing::rectangle(1, 1, n, 1);
    Points2 flat(mesh.vertex_count(), 2);
    const auto wound = [&](double turns) {
        for (int v = 0; v < mesh.vertex_count(); ++v) {
            const double angle = 2 * std::numbers::pi * turns * mesh.positions(v, 0);
            const double radius = 2 - mesh.positions(v, 1);
            flat.row(v) << radius * std::cos(angle), radius * std::sin(angle);
        }
        return overlapping_triangles(mesh.triangles, flat).size();
    };
    EXPECT_EQ(wound(0.97), 0u);
    EXPECT_GT(wound(1.5), static_cast<std::size_t>(n / 2));
}

TEST(OverlappingTriangles, AgreesWithSamplingOnRandomTriangles) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> uniform(0, 1);
    const int count = 40;
    Triangles triangles(count, 3);
    Points2 flat(3 * count, 2);
    for (int t = 0; t < count; ++t) {
        triangles.row(t) << 3 * t, 3 * t + 1, 3 * t + 2;
        const Vec2 middle(uniform(random), uniform(random));
        for (int k = 0; k < 3; ++k)
            flat.row(3 * t + k) = (middle + 0.15 * Vec2(uniform(random), uniform(random))).transpose();
    }
    const auto inside = [&](int t, const Vec2& p) {
        const Vec2 a = flat.row(3 * t), b = flat.row(3 * t + 1), c = flat.row(3 * t + 2);
        const double s = signed_area(a, b, c) > 0 ? 1 : -1;
        return s * signed_area(a, b, p) > 0 && s * signed_area(b, c, p) > 0 && s * signed_area(c, a, p) > 0;
    };
    const auto pairs = overlapping_triangles(triangles, flat);
    const auto found = [&](int a, int b) {
        return std::find(pairs.begin(), pairs.end(), std::array<int, 2>{a, b}) != pairs.end();
    };
    int sampled = 0;
    for (int a = 0; a < count; ++a)
        for (int b = a + 1; b < count; ++b) {
            bool common = false;
            for (int i = 0; i < 60 && !common; ++i)
                for (int j = 0; j < 60 - i && !common; ++j) {
                    const double u = (i + 0.3) / 60, v = (j + 0.3) / 60;
                    const Vec2 p = (1 - u - v) * Vec2(flat.row(3 * a)) + u * Vec2(flat.row(3 * a + 1)) +
                                   v * Vec2(flat.row(3 * a + 2));
                    common = inside(b, p);
                }
            if (common) {
                ++sampled;
                EXPECT_TRUE(found(a, b)) << a << " and " << b;
            }
        }
    EXPECT_GT(sampled, 5);
    EXPECT_LE(pairs.size(), static_cast<std::size_t>(sampled + 8));  // small overlaps that the samples miss
}

}  // namespace overlap_test
}  // namespace ripstop
