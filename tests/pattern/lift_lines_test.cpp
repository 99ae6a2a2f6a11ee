#include "ripstop/pattern/drawing/lift_lines.h"

#include <gtest/gtest.h>

#include <cmath>

#include "ripstop/pattern/piece/drawn_lines.h"
#include "support/flat_tiles.h"

namespace ripstop {
namespace lift_lines_test {

double length(const Points3& line) {
    return (line.bottomRows(line.rows() - 1) - line.topRows(line.rows() - 1)).rowwise().norm().sum();
}

Points2 segment(const Vec2& from, const Vec2& to) {
    Points2 line(2, 2);
    line.row(0) = from;
    line.row(1) = to;
    return line;
}

TEST(LiftLine, KeepsItsLengthOnASheetThatIsBentWithoutStretch) {
    const FlatTile tile = testing::flat_cylinder("sheet");
    const Points2& flat = tile.flattening.positions;
    const Vec2 lower = flat.colwise().minCoeff(), upper = flat.colwise().maxCoeff();
    const Vec2 from = lower + 0.2 * (upper - lower), to = lower + 0.8 * (upper - lower);
    const std::vector<Points3> lifted = lift_line(tile.tile.mesh, flat, segment(from, to));
    ASSERT_EQ(lifted.size(), 1U);
    EXPECT_GT(lifted[0].rows(), 3) << "a point at every edge it crosses";
    EXPECT_NEAR(length(lifted[0]), (to - from).norm(), 1e-9);
}

TEST(LiftLine, ComesBackToTheSamePlaceOnTheCloth) {
    FlatTile tile = testing::sinusoidal_gore("gore");
    const Points2& flat = tile.flattening.positions;
    const Vec2 middle = flat.colwise().mean();
    const double size = (flat.colwise().maxCoeff() - flat.colwise().minCoeff()).minCoeff();
    const Vec2 from = middle - Vec2(0.1, 0.05) * size, to = middle + Vec2(0.15, 0.1) * size;
    const std::vector<Points3> lifted = lift_line(tile.tile.mesh, flat, segment(from, to));
    ASSERT_EQ(lifted.size(), 1U);
    tile.tile.lines = {{"stripe", lifted[0]}};
    const Points2 back = draw_lines(tile, 1e-9).at(0).points;
    EXPECT_NEAR((Vec2(back.row(0)) - from).norm(), 0, 1e-9);
    EXPECT_NEAR((Vec2(back.row(back.rows() - 1)) - to).norm(), 0, 1e-9);
}

TEST(LiftLine, EndsWhereItLeavesTheClothAndBeginsAgainWhereItComesBack) {
    // A U of three squares, open to +y: a line across its legs leaves the cloth between them.
    Points2 corners(8, 2);
    corners << 0, 0, 3, 0, 3, 2, 2, 2, 2, 1, 1, 1, 1, 2, 0, 2;
    TriangleMesh mesh;
    mesh.positions = Points3::Zero(8, 3);
    mesh.positions.leftCols(2) = corners;
    mesh.positions.col(2).setConstant(5);
    mesh.triangles.resize(6, 3);
    mesh.triangles << 0, 5, 7, 5, 6, 7, 0, 1, 5, 1, 4, 5, 1, 2, 4, 2, 3, 4;
    const std::vector<Points3> lifted = lift_line(mesh, corners, segment({-1, 1.5}, {4, 1.5}));
    ASSERT_EQ(lifted.size(), 2U);
    EXPECT_NEAR(length(lifted[0]), 1, 1e-12);
    EXPECT_NEAR(length(lifted[1]), 1, 1e-12);
    EXPECT_NEAR(lifted[1](0, 0), 2, 1e-12);
    EXPECT_EQ(lifted[1](0, 2), 5);
    EXPECT_TRUE(lift_line(mesh, corners, segment({1.2, 1.5}, {1.8, 1.5})).empty()) << "wholly beside the cloth";
}

TEST(LiftLine, RunsAlongAnEdgeOfTheMeshOnce) {
    const FlatTile tile = testing::flat_polygon("square", (Points2(4, 2) << 0, 0, 1, 0, 1, 1, 0, 1).finished());
    const auto& triangles = tile.tile.mesh.triangles;
    const Vec2 a = tile.flattening.positions.row(triangles(0, 0)), b = tile.flattening.positions.row(triangles(0, 1));
    const std::vector<Points3> lifted = lift_line(tile.tile.mesh, tile.flattening.positions, segment(a, b));
    ASSERT_EQ(lifted.size(), 1U);
    EXPECT_NEAR(length(lifted[0]), (b - a).norm(), 1e-12);
}

}  // namespace lift_lines_test
}  // namespace ripstop
