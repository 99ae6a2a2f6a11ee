#include "ripstop/flatten/map/lscm.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "ripstop/mesh/change/flips.h"
#include "ripstop/tile/make_tile.h"
#include "support/flat_errors.h"
#include "support/shapes.h"

namespace ripstop {
namespace lscm_test {

TEST(Lscm, IsExactOnDevelopables) {
    for (const auto& shape : testing::developable_shapes()) {
        SCOPED_TRACE(shape.name);
        const Tile tile = make_tile(shape.name, shape.mesh);
        const Flattening flat = flatten_lscm(tile);
        ASSERT_EQ(flat.summary.termination, Termination::converged) << flat.summary.text();
        EXPECT_LT(testing::worst_edge_error(shape.mesh, flat.positions), 1e-9);  // the condition number is about 1e5
        EXPECT_EQ(count_flipped(shape.mesh.triangles, flat.positions), 0);
    }
}

TEST(Lscm, KeepsTheAreaOfACurvedTile) {
    for (const auto& shape : testing::curved_shapes()) {
        SCOPED_TRACE(shape.name);
        const Tile tile = make_tile(shape.name, shape.mesh);
        const Flattening flat = flatten_lscm(tile);
        ASSERT_TRUE(flat.summary.usable());
        EXPECT_NEAR(testing::area_error(tile, flat.positions), 0, 1e-12);
        EXPECT_EQ(count_flipped(shape.mesh.triangles, flat.positions), 0);
        EXPECT_EQ(flat.summary.reason, "one linear system solved");
    }
}

TEST(Lscm, KeepsTheAnglesOfAFineCap) {
    // A conformal map of a cap; the discrete one converges to it with the mesh size.
    const Tile tile = make_tile("cap", testing::cap(0.4, 16));
    const Flattening flat = flatten_lscm(tile);
    double worst = 0;
    for (int t = 0; t < tile.mesh.triangle_count(); ++t)
        for (int k = 0; k < 3; ++k) {
            const auto at = [&](int c) {
                const Vec2 p = flat.positions.row(tile.mesh.triangles(t, (k + c) % 3));
                return Vec3(p.x(), p.y(), 0);
            };
            const double drawn =
                angle_at(tile.mesh.corner(t, k), tile.mesh.corner(t, (k + 1) % 3), tile.mesh.corner(t, (k + 2) % 3));
            worst = std::max(worst, std::abs(angle_at(at(0), at(1), at(2)) - drawn));
        }
    EXPECT_LT(worst, 2e-2);
}

TEST(Lscm, LaysTheWarpAlongX) {
    TileOptions options;
    options.warp = Vec3(0, 0, 1);
    const Tile tile = make_tile("cylinder", testing::cylinder(1, 1.2, 2, 12, 16), options);
    const Flattening flat = flatten_lscm(tile);
    const Vec2 size = flat.positions.colwise().maxCoeff() - flat.positions.colwise().minCoeff();
    EXPECT_NEAR(size.x(), 2, 1e-9);
    EXPECT_NEAR(size.y(), 12 * 2 * std::sin(1.2 / 24), 1e-9);  // twelve chords
}

TEST(Lscm, DoesNotCareHowVerticesAreNumberedOrWhereTheTileStands) {
    TileOptions options;
    options.warp = Vec3(0.2, 0.5, 1);  // given, because a round cap has no longest axis
    for (const auto& shape : testing::curved_shapes()) {
        SCOPED_TRACE(shape.name);
        const Points2 plain = flatten_lscm(make_tile(shape.name, shape.mesh, options)).positions;
        std::vector<int> order;
        const TriangleMesh shuffled = testing::shuffled(shape.mesh, 7, &order);
        const Points2 numbered = flatten_lscm(make_tile(shape.name, shuffled, options)).positions;
        EXPECT_LT(testing::distance_up_to_half_turn(numbered, plain(order, Eigen::all)), 1e-9);
    }
    const TriangleMesh gore = testing::lune(std::numbers::pi / 6, 8, 48);
    const Points2 plain = flatten_lscm(make_tile("gore", gore)).positions;
    const Points2 moved = flatten_lscm(make_tile("gore", testing::moved(gore))).positions;
    EXPECT_LT(testing::distance_up_to_half_turn(moved, plain), 1e-9);
}

}  // namespace lscm_test
}  // namespace ripstop
