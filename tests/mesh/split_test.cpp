#include "ripstop/mesh/change/split.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ripstop/mesh/boundary.h"
#include "ripstop/model/tile/tile.h"
#include "ripstop/tile/make_tile.h"
#include "support/shapes.h"

namespace ripstop {
namespace split_test {

Eigen::VectorXd plane(const TriangleMesh& mesh, const Vec3& normal, double offset) {
    return (mesh.positions * normal).array() - offset;
}

void expect_sound(const TriangleMesh& whole, const MeshSplit& split) {
    EXPECT_NEAR(surface_area(split.left.mesh) + surface_area(split.right.mesh), surface_area(whole),
                1e-13 * surface_area(whole));
    ASSERT_EQ(split.left.cut.size(), split.right.cut.size());
    for (std::size_t i = 0; i < split.left.cut.size(); ++i)
        EXPECT_EQ(Vec3(split.left.mesh.positions.row(split.left.cut[i])),
                  Vec3(split.right.mesh.positions.row(split.right.cut[i])))
            << "the same point, bit for bit";
    const auto outline = [](const MeshHalf& half) {
        return edge_lengths(half.mesh.positions, closed(half.boundary)).sum();
    };
    const double cut = edge_lengths(split.left.mesh.positions, split.left.cut).sum();
    const Tile tile = make_tile("whole", whole);
    EXPECT_NEAR(outline(split.left) + outline(split.right) - 2 * cut,
                edge_lengths(whole.positions, closed(tile.boundary)).sum(), 1e-12);
}

TEST(SplitMesh, CutsEveryShapeInTwoDisksThatAddUp) {
    for (const auto& shapes : {testing::developable_shapes(), testing::curved_shapes()})
        for (const testing::Shape& shape : shapes)
            for (const Vec3& normal : {Vec3(1, 0.2, 0.1), Vec3(0.1, 1, 0.3)}) {
                SCOPED_TRACE(shape.name);
                const Eigen::VectorXd heights = plane(shape.mesh, normal, 0);
                const double middle = (heights.minCoeff() + heights.maxCoeff()) / 2;
                const auto split = split_mesh(shape.mesh, heights.array() - middle);
                if (!split) continue;  // a plane may meet a curved surface twice
                expect_sound(shape.mesh, *split);
            }
}

TEST(SplitMesh, OnAStraightLineTheHalvesAreExact) {
    const TriangleMesh sheet = testing::rectangle(2, 1, 7, 4);
    const auto split = split_mesh(sheet, plane(sheet, Vec3::UnitX(), 0.7), 0);
    ASSERT_TRUE(split);
    expect_sound(sheet, *split);
    EXPECT_NEAR(surface_area(split->left.mesh), 1.3, 1e-14) << "left is where the field is positive";
    EXPECT_NEAR(surface_area(split->right.mesh), 0.7, 1e-14);
    for (const int v : split->left.cut) EXPECT_NEAR(split->left.mesh.positions(v, 0), 0.7, 1e-15);
    // Along the cut, seen from outside (+z), the left half is on the left. x grows to the left, so the cut runs
    // down.
    EXPECT_NEAR(split->left.mesh.positions(split->left.cut.front(), 1), 1, 1e-15);
    EXPECT_NEAR(split->left.mesh.positions(split->left.cut.back(), 1), 0, 1e-15);
}

TEST(SplitMesh, GoesThroughVerticesThatAreNear) {
    const TriangleMesh sheet = testing::rectangle(2, 1, 4, 4);
    const auto split = split_mesh(sheet, plane(sheet, Vec3::UnitX(), 1.004));
    ASSERT_TRUE(split);
    expect_sound(sheet, *split);
    EXPECT_EQ(split->left.mesh.triangle_count() + split->right.mesh.triangle_count(), sheet.triangle_count());
    EXPECT_EQ(split->left.cut.size(), 5u);
    for (const int v : split->left.cut) {
        const SplitVertex& source = split->left.source[static_cast<std::size_t>(v)];
        EXPECT_EQ(source.a, source.b);
    }
}

TEST(SplitMesh, TellsWhereTheLineRunsOnTheEdgesOfTheWhole) {
    const TriangleMesh sheet = testing::rectangle(1, 1, 1, 1);
    const auto split = split_mesh(sheet, plane(sheet, Vec3::UnitX(), 0.25));
    ASSERT_TRUE(split);
    for (const MeshHalf* half : {&split->left, &split->right})
        for (std::size_t v = 0; v < half->source.size(); ++v) {
            const SplitVertex& at = half->source[v];
            const Vec3 a = sheet.positions.row(at.a), b = sheet.positions.row(at.b);
            EXPECT_LT((a + at.share * (b - a) - Vec3(half->mesh.positions.row(static_cast<Eigen::Index>(v)))).norm(),
                      1e-15);
        }
}

TEST(SplitMesh, RefusesALineThatDoesNotDivideInTwo) {
    const TriangleMesh sheet = testing::rectangle(2, 1, 8, 4);
    EXPECT_FALSE(split_mesh(sheet, plane(sheet, Vec3::UnitX(), 3))) << "beside it";
    EXPECT_FALSE(split_mesh(sheet, (sheet.positions.col(0).array() - 1).abs() - 0.3)) << "three pieces";
    const Eigen::VectorXd hole =
        ((sheet.positions.col(0).array() - 1).square() + (sheet.positions.col(1).array() - 0.5).square()).sqrt() - 0.3;
    EXPECT_FALSE(split_mesh(sheet, hole)) << "a ring and a disk";
}

}  // namespace split_test
}  // namespace ripstop
