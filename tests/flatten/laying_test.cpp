#include "ripstop/flatten/tools/laying.h"
#include "ripstop/mesh/change/flips.h"

#include "support/shapes.h"

namespace ripstop {
namespace laying_test {

TEST(LayOnMissing, IsExactOnADevelopableFromOneTriangle) {
    const TriangleMesh mesh = testing::cone(0.5, 2, 1, 2.5, 16, 12);
    const Adjacency adjacency(mesh.triangles, mesh.vertex_count());
    Points2 flat(mesh.vertex_count(), 2);
    const std::vector<bool> none(static_cast<std::size_t>(mesh.vertex_count()), false);
    EXPECT_EQ(lay_on_missing(mesh, 100, none, flat), mesh.vertex_count());
    for (const int h : adjacency.edges()) {
        const double length = (mesh.positions.row(adjacency.from(h)) - mesh.positions.row(adjacency.to(h))).norm();
        EXPECT_NEAR((flat.row(adjacency.from(h)) - flat.row(adjacency.to(h))).norm(), length, 1e-12);
    }
    EXPECT_EQ(count_flipped(mesh.triangles, flat), 0);
}

TEST(LayOnMissing, LeavesWhatIsPlaced) {
    const TriangleMesh mesh = testing::rectangle(2, 1, 4, 2);
    Points2 flat = mesh.positions.leftCols(2);
    std::vector<bool> placed(static_cast<std::size_t>(mesh.vertex_count()), true);
    for (const int v : {3, 4, 8, 9}) {
        placed[static_cast<std::size_t>(v)] = false;
        flat.row(v).setConstant(std::nan(""));
    }
    EXPECT_EQ(lay_on_missing(mesh, 0, placed, flat), 4);
    EXPECT_LT((flat - mesh.positions.leftCols(2)).cwiseAbs().maxCoeff(), 1e-14);
}

TEST(RepairFlippedTriangles, BringsAVertexBackAndTouchesNothingFarAway) {
    const TriangleMesh mesh = testing::rectangle(2, 2, 8, 8);
    const Adjacency adjacency(mesh.triangles, mesh.vertex_count());
    Points2 flat = mesh.positions.leftCols(2);
    const int middle = 40;
    flat.row(middle) += Eigen::RowVector2d(0.45, 0.3);
    ASSERT_GT(count_flipped(mesh.triangles, flat), 0);
    EXPECT_EQ(repair_flipped_triangles(mesh, adjacency, 50, flat), 0);
    EXPECT_EQ(count_flipped(mesh.triangles, flat), 0);
    EXPECT_EQ(flat.row(0), mesh.positions.row(0).leftCols(2));
    EXPECT_EQ(flat.row(80), mesh.positions.row(80).leftCols(2));
}

TEST(RepairFlippedTriangles, NeverLeavesMoreThanThereWere) {
    const TriangleMesh mesh = testing::rectangle(1, 1, 10, 10);
    const Adjacency adjacency(mesh.triangles, mesh.vertex_count());
    Points2 folded = mesh.positions.leftCols(2);
    folded.col(0) = (folded.col(0).array() - 0.5).abs();  // half of it is flipped: no local repair can help
    const int before = count_flipped(mesh.triangles, folded);
    ASSERT_EQ(before, 100);
    EXPECT_LE(repair_flipped_triangles(mesh, adjacency, 50, folded), before);
    EXPECT_TRUE(folded.allFinite());
}

}  // namespace laying_test
}  // namespace ripstop
