#include "ripstop/mesh/unroll.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <numbers>

#include "ripstop/geometry/triangle.h"
#include "support/closed_tiles.h"
#include "support/shapes.h"

namespace ripstop {
namespace unroll_test {

constexpr double pi = std::numbers::pi;

/// The largest distance between the places of a vertex in its triangles.
double parted(const TriangleMesh& mesh) {
    const std::vector<LaidTriangle> laid = unroll(mesh, Adjacency(mesh.triangles, mesh.vertex_count()));
    Points2 low = Points2::Constant(mesh.vertex_count(), 2, 1e9), high = -low;
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        const LaidTriangle& here = laid[static_cast<std::size_t>(t)];
        EXPECT_NEAR(here.turn.determinant(), 1, 1e-12);
        const Mat22 flat = lay_flat(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2));
        for (int k = 0; k < 3; ++k) {
            const Vec2 x = here.origin + (k == 0 ? Vec2(Vec2::Zero()) : Vec2(here.turn * flat.col(k - 1)));
            low.row(mesh.triangles(t, k)) = low.row(mesh.triangles(t, k)).cwiseMin(x.transpose());
            high.row(mesh.triangles(t, k)) = high.row(mesh.triangles(t, k)).cwiseMax(x.transpose());
        }
    }
    return (high - low).rowwise().norm().maxCoeff();
}

TEST(Unroll, FitsTogetherOnDevelopables) {
    EXPECT_LT(parted(testing::round_tube(1, 2, 12, 5)), 1e-12);
    EXPECT_LT(parted(testing::cone(pi / 6, 2 * pi, 1, 2.5, 24, 4)), 1e-12);
    EXPECT_LT(parted(testing::helical_tube(1, 2, 12, 3, 5)), 1e-12);
    EXPECT_LT(parted(testing::shuffled(testing::rectangle(2, 1, 8, 8), 4)), 1e-12);
}

TEST(Unroll, PartsWhereTheMeshIsCurved) {
    EXPECT_GT(parted(testing::cap(0.8, 6)), 0.01);
}

}  // namespace unroll_test
}  // namespace ripstop
