#include "ripstop/mesh/sight_lines.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <random>

#include "support/shapes.h"

namespace ripstop {
namespace sight_lines_test {

/// Solves the three equations for the intersection of the line with each triangle's plane.
bool is_blocked_by_any(const TriangleMesh& mesh, const Vec3& from, const Vec3& direction, double least) {
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        Eigen::Matrix3d columns;
        columns << mesh.corner(t, 1) - mesh.corner(t, 0), mesh.corner(t, 2) - mesh.corner(t, 0), -direction;
        if (std::abs(columns.determinant()) < 1e-12) continue;
        const Vec3 at = columns.inverse() * (from - mesh.corner(t, 0));
        if (at[0] >= 0 && at[1] >= 0 && at[0] + at[1] <= 1 && at[2] > least) return true;
    }
    return false;
}

TEST(SightLines, AreBlockedWhereATriangleIsMet) {
    const TriangleMesh mesh = testing::torus_patch(2, 0.7, 4, -2.5, 2.5, 24, 16);
    const SightLines cloth({&mesh});
    std::mt19937 random(3);
    const auto pick = [&] { return 6.0 * static_cast<double>(random() % 100000) / 100000 - 3; };
    int blocked = 0;
    for (int k = 0; k < 500; ++k) {
        const Vec3 from(pick(), pick(), pick()), direction = Vec3(pick(), pick(), pick()).normalized();
        const bool expected = is_blocked_by_any(mesh, from, direction, 0.1);
        EXPECT_EQ(cloth.is_blocked(from, direction, 0.1), expected) << k;
        blocked += expected;
    }
    EXPECT_GT(blocked, 50);
    EXPECT_LT(blocked, 400);
}

TEST(SightLines, AreOpenWhereThereIsNothing) {
    EXPECT_FALSE(SightLines({}).is_blocked(Vec3::Zero(), Vec3::UnitX(), 0));
    const TriangleMesh sheet = testing::rectangle(1, 1, 2, 2);
    const SightLines cloth({&sheet});
    EXPECT_TRUE(cloth.is_blocked(Vec3(0.4, 0.3, 1), -Vec3::UnitZ(), 0));
    EXPECT_FALSE(cloth.is_blocked(Vec3(0.4, 0.3, 1), Vec3::UnitZ(), 0)) << "it lies behind";
    EXPECT_FALSE(cloth.is_blocked(Vec3(0.4, 0.3, 1), -Vec3::UnitZ(), 1.5)) << "it lies nearer";
    EXPECT_FALSE(cloth.is_blocked(Vec3(0.4, 0.3, 1), Vec3::UnitX(), 0)) << "it lies beside";
}

}  // namespace sight_lines_test
}  // namespace ripstop
