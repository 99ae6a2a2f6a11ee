#include "ripstop/flatten/weave/kub10.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "ripstop/base/error.h"
#include "ripstop/mesh/change/flips.h"
#include "ripstop/tile/make_tile.h"
#include "support/flat_errors.h"
#include "support/shapes.h"

namespace ripstop {
namespace kub10_test {

TEST(Kub10, IsExactOnAPlaneInAnyPose) {
    const TriangleMesh mesh = testing::moved(testing::rectangle(2, 1, 12, 6));
    const Flattening flat = flatten_kub10(make_tile("plane", mesh));
    EXPECT_EQ(flat.summary.termination, Termination::converged) << flat.summary.text();
    EXPECT_LT(testing::worst_edge_error(mesh, flat.positions), 1e-12);
}

TEST(Kub10, ComesNearerToADevelopableTheLongerItMaySettle) {
    const Tile tile = make_tile("cylinder", testing::cylinder(1, 1.2, 2, 12, 16));
    const auto error = [&](int sweeps) {
        WovenOptions options = kub10_options;
        options.energy_tolerance = 1e-6;
        options.max_iterations = sweeps;
        return testing::worst_edge_error(tile.mesh, flatten_kub10(tile, options).positions);
    };
    const double none = error(0), some = error(100), many = error(400);
    EXPECT_GT(none, 0.05);  // the projection: the cosine of 0.6 rad at the sides
    EXPECT_LT(some, 0.3 * none);
    EXPECT_LT(many, 0.3 * some);
}

TEST(Kub10, DependsOnTheProjection) {
    // A gore from pole to pole is parallel to the line of sight at its ends; a spherical square nowhere is.
    const Tile square = make_tile("square", testing::spherical_square(0.3, 12));
    const Tile gore = make_tile("gore", testing::lune(2 * std::numbers::pi / 24, 6, 48));
    const auto away = [](const Tile& tile) {
        return std::abs(testing::perimeter_error(tile, flatten_kub10(tile).positions) -
                        testing::perimeter_error(tile, flatten_woven(tile, Fabric{}, kub10_options).positions));
    };
    EXPECT_LT(away(square), 0.003);
    EXPECT_GT(away(gore), 0.004);
}

TEST(Kub10, LaysAFoldedTileTriangleByTriangleAndSaysSo) {
    // two planes, each at 63 degrees: no crossing has a place
    const TriangleMesh mesh =
        testing::grid(12, 6, [](double u, double v) { return Vec3(2 * std::abs(u - 0.5), v, u - 0.5); });
    const Flattening flat = flatten_kub10(make_tile("folded", mesh));
    EXPECT_NE(flat.summary.reason.find("placed from their neighbours"), std::string::npos) << flat.summary.text();
    EXPECT_EQ(count_flipped(mesh.triangles, flat.positions), 0);
}

TEST(Kub10, RefusesOptionsOutOfRange) {
    const Tile tile = make_tile("plane", testing::rectangle(1, 1, 2, 2));
    EXPECT_THROW(flatten_kub10(tile, {.spacing = 0}), InputError);
    EXPECT_THROW(flatten_kub10(tile, {.max_iterations = -1}), InputError);
}

}  // namespace kub10_test
}  // namespace ripstop
