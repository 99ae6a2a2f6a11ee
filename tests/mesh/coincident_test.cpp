#include "ripstop/mesh/change/coincident.h"

#include <gtest/gtest.h>

#include "ripstop/mesh/components.h"
#include "support/shapes.h"

namespace ripstop {
namespace coincident_test {

/// The mesh with three separate vertices for each triangle.
TriangleMesh exploded(const TriangleMesh& mesh) {
    TriangleMesh result{Points3(3 * mesh.triangle_count(), 3), Triangles(mesh.triangle_count(), 3)};
    for (int t = 0; t < mesh.triangle_count(); ++t)
        for (int k = 0; k < 3; ++k) {
            result.positions.row(3 * t + k) = mesh.corner(t, k).transpose();
            result.triangles(t, k) = 3 * t + k;
        }
    return result;
}

TEST(Coincident, JoiningWhatWasTornApartGivesTheSurfaceBack) {
    const TriangleMesh mesh = testing::octant(5);
    const TriangleMesh joined = join_coincident(exploded(mesh));
    EXPECT_EQ(joined.vertex_count(), mesh.vertex_count());
    EXPECT_EQ(exploded(joined).positions, exploded(mesh).positions) << "every corner is where it was";
    EXPECT_EQ(exploded(mesh).triangle_count(), joined.triangle_count());
}

TEST(Coincident, JoinsOverTheSignOfZeroAndNothingThatIsApart) {
    TriangleMesh mesh{Points3(6, 3), Triangles(2, 3)};
    mesh.positions << 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, -0.0, 0, 1, 1, 0, 1e-300, 1, 0;
    mesh.triangles << 0, 1, 2, 3, 4, 5;
    const TriangleMesh joined = join_coincident(mesh);
    EXPECT_EQ(joined.vertex_count(), 5);
    EXPECT_EQ(joined.triangles(1, 0), 1);
    EXPECT_EQ(joined.triangles(1, 2), 4);
}

TEST(Coincident, DropsWhatNoTriangleUsesAndKeepsTheOrder) {
    TriangleMesh mesh{Points3(5, 3), Triangles(1, 3)};
    mesh.positions << 9, 9, 9, 0, 0, 0, 8, 8, 8, 1, 0, 0, 0, 1, 0;
    mesh.triangles << 4, 1, 3;
    const TriangleMesh used = drop_unused(mesh);
    Points3 expected(3, 3);
    expected << 0, 0, 0, 1, 0, 0, 0, 1, 0;
    EXPECT_EQ(used.positions, expected);
    EXPECT_EQ(used.triangles.row(0), Eigen::RowVector3i(2, 0, 1));
}

}  // namespace coincident_test
}  // namespace ripstop
