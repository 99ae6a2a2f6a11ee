#include "ripstop/tile/cloth_warp.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "ripstop/base/error.h"
#include "ripstop/base/text/units.h"
#include "ripstop/model/tile/tile.h"
#include "ripstop/tile/make_tile.h"
#include "ripstop/tile/targets.h"
#include "support/closed_tiles.h"
#include "support/shapes.h"

namespace ripstop {
namespace cloth_warp_test {

constexpr double pi = std::numbers::pi;

Points3 one(const Vec3& direction) {
    return direction.transpose();
}

/// The direction around z at the middle of each triangle, in the polygon's direction.
Vec3 round_z(const TriangleMesh& mesh, int t) {
    Vec3 normal = (mesh.corner(t, 1) - mesh.corner(t, 0)).cross(mesh.corner(t, 2) - mesh.corner(t, 0));
    return Vec3::UnitZ().cross(normal).normalized();
}

TEST(ClothWarp, IsTheProjectionWhereThatHasADirectionOnTheCloth) {
    for (const auto& shapes : {testing::developable_shapes(), testing::curved_shapes()})
        for (const auto& shape : shapes) {
            SCOPED_TRACE(shape.name);
            const Vec3 direction = Vec3(0.2, 1, 0.5).normalized();
            const ClothWarp warp = lay_on_cloth(shape.mesh, one(direction));
            EXPECT_FALSE(warp.laid_on_cloth);
            const Points3 found = warp_in_space(shape.mesh, warp.along);
            for (int t = 0; t < shape.mesh.triangle_count(); ++t) {
                const Vec3 normal = (shape.mesh.corner(t, 1) - shape.mesh.corner(t, 0))
                                        .cross(shape.mesh.corner(t, 2) - shape.mesh.corner(t, 0))
                                        .normalized();
                const Vec3 expected = (direction - direction.dot(normal) * normal).normalized();
                EXPECT_LT((Vec3(found.row(t)) - expected).norm(), 1e-9);
            }
        }
}

TEST(ClothWarp, OfAHorizontalDirectionOnATubeRunsRoundIt) {
    for (const int sides : {4, 5, 12, 48})
        for (const double angle : {0.0, 0.2, 1.1}) {
            const TriangleMesh standing = testing::round_tube(1, 2, sides, 2);
            const ClothWarp warp = lay_on_cloth(standing, one({std::cos(angle), std::sin(angle), 0}));
            EXPECT_TRUE(warp.laid_on_cloth);
            const Points3 found = warp_in_space(standing, warp.along);
            const double sense = found.row(0).dot(round_z(standing, 0));
            for (int t = 0; t < standing.triangle_count(); ++t)
                EXPECT_NEAR(found.row(t).dot(round_z(standing, t)) * sense, 1, 1e-12) << sides << " sides, " << angle;
        }
}

/// Expects the warp (or `found`) of a cone's triangles at phi = 0, opposite its cut, to be along y.
void expect_round_in_the_middle(const TriangleMesh& cone, const Points3& found) {
    for (int t = 0; t < cone.triangle_count(); ++t) {
        const Vec3 middle = (cone.corner(t, 0) + cone.corner(t, 1) + cone.corner(t, 2)) / 3;
        if (std::abs(std::atan2(middle.y(), middle.x())) > 2 * pi / 24) continue;
        EXPECT_GT(std::abs(found(t, 1)), 0.99);
    }
}

TEST(ClothWarp, RunsAlongThePatternWhereItHasNoAxisOfItsOwn) {
    // at this angle, lines around the cone take nearly all directions on its sector, whose long axis runs across
    // its middle
    const TriangleMesh mesh = testing::cone(0.3, 2 * pi, 1, 2.5, 24, 4);
    const ClothWarp warp = lay_on_cloth(mesh, one(Vec3::UnitY()));
    EXPECT_TRUE(warp.laid_on_cloth);
    expect_round_in_the_middle(mesh, warp_in_space(mesh, warp.along));
}

TEST(ClothWarp, LongestAxisMovesWithATileThatHasNoneInSpace) {
    for (const double half : {0.2, 0.3, 0.5, 0.8, 1.2}) {
        SCOPED_TRACE(half);
        const TriangleMesh mesh = testing::cone(half, 2 * pi, 1, 1.5, 24, 4);
        const Vec3 axis = longest_axis(mesh);
        EXPECT_NEAR(std::abs(axis.y()), 1, 0.01);
        const Eigen::Matrix2Xd here = warp_in_triangles(make_tile("t", mesh));
        const TriangleMesh elsewhere = testing::moved(mesh);
        const Eigen::Matrix2Xd there = warp_in_triangles(make_tile("t", elsewhere));
        EXPECT_LT(std::min((here - there).cwiseAbs().maxCoeff(), (here + there).cwiseAbs().maxCoeff()), 1e-9);
    }
}

TEST(ClothWarp, TurnsWithinTheTriangles) {
    const TriangleMesh mesh = testing::round_tube(1, 2, 12, 2);
    const ClothWarp warp = lay_on_cloth(mesh, one(Vec3::UnitZ()));
    EXPECT_FALSE(warp.laid_on_cloth);
    const Points3 turned = warp_in_space(mesh, warp.along, -pi / 2);
    for (int t = 0; t < mesh.triangle_count(); ++t) EXPECT_NEAR(turned.row(t).dot(round_z(mesh, t)), 1, 1e-12);
}

TEST(ClothWarp, IsSaidInTheTilesSource) {
    const TriangleMesh tube = testing::round_tube(1, 2, 12, 2), sheet = testing::rectangle(2, 1, 4, 2);
    EXPECT_EQ(make_tile("t", sheet).grain.source, "longest axis");
    EXPECT_EQ(make_tile("t", tube).grain.source,
              "longest axis, laid along the cloth because the tile goes right round");
    EXPECT_EQ(make_tile("t", tube, {.warp = Vec3::UnitX()}).grain.source,
              "given, laid along the cloth because the tile goes right round");
    EXPECT_EQ(make_tile("t", tube, {.warp = Vec3::UnitZ()}).grain.source, "given");
}

TEST(ClothWarp, TurnedFromTheLongestAxisTurnsOnTheClothOfATube) {
    const TriangleMesh tube = testing::round_tube(1, 2, 12, 2);
    const Tile plain = make_tile("t", tube), turned = make_tile("t", tube, {.grain_turn = 30 * degree});
    const Eigen::Matrix2Xd before = warp_in_triangles(plain), after = warp_in_triangles(turned);
    for (int t = 0; t < tube.triangle_count(); ++t)
        EXPECT_NEAR(
            std::atan2(before(0, t) * after(1, t) - before(1, t) * after(0, t), before.col(t).dot(after.col(t))),
            30 * degree, 1e-12);
    EXPECT_EQ(turned.grain.source,
              "longest axis turned by 30 degrees, laid along the cloth because the tile goes right round");
}

TEST(ClothWarp, OfTrianglesMayRunRoundATube) {
    const TriangleMesh tube = testing::round_tube(1, 2, 12, 2);
    TileOptions options;
    options.warp_field.resize(tube.triangle_count(), 3);
    for (int t = 0; t < tube.triangle_count(); ++t) options.warp_field.row(t) = round_z(tube, t);
    const Tile tile = make_tile("t", tube, options);
    EXPECT_NEAR(tile.grain.direction.norm(), 1, 1e-12);
    const Points3 found = warp_in_space(tube, warp_in_triangles(tile));
    EXPECT_LT((found - options.warp_field).cwiseAbs().maxCoeff(), 1e-12);
    options.warp_field.topRows(tube.triangle_count() / 2) *= -1;
    EXPECT_THROW(make_tile("t", tube, options), InputError);
}

}  // namespace cloth_warp_test
}  // namespace ripstop
