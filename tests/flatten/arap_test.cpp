#include "ripstop/flatten/map/arap.h"

#include <gmock/gmock.h>

#include <numbers>

#include "ripstop/base/error.h"
#include "ripstop/flatten/map/tutte.h"
#include "ripstop/mesh/change/flips.h"
#include "ripstop/tile/make_tile.h"
#include "support/flat_errors.h"
#include "support/shapes.h"

namespace ripstop {
namespace arap_test {

TEST(Arap, IsExactOnDevelopables) {
    for (const auto& shape : testing::developable_shapes()) {
        SCOPED_TRACE(shape.name);
        const Flattening flat = flatten_arap(make_tile(shape.name, shape.mesh));
        ASSERT_EQ(flat.summary.termination, Termination::converged) << flat.summary.text();
        EXPECT_LT(testing::worst_edge_error(shape.mesh, flat.positions), 1e-9);
    }
}

TEST(Arap, ForgetsItsStart) {
    // From Tutte's disk back to the rectangle. The error falls by a constant factor per iteration, so stopping at
    // steps of 1e-10 leaves about a hundred times that.
    const TriangleMesh mesh = testing::cylinder(1, 1.2, 2, 12, 16);
    const Tile tile = make_tile("cylinder", mesh);
    const Flattening flat = flatten_arap(tile, flatten_tutte(tile).positions, {.tolerance = 1e-10});
    ASSERT_EQ(flat.summary.termination, Termination::converged) << flat.summary.text();
    EXPECT_LT(testing::worst_edge_error(mesh, flat.positions), 1e-6);
}

TEST(Arap, GivesAQuarterSphereItsKnownErrors) {
    // Free boundary, isotropic: an independent program gives perimeter +10.5 %, area -0.4 %.
    const Tile tile = make_tile("quarter sphere", testing::lune(std::numbers::pi / 2, 24, 48));
    const Flattening flat = flatten_arap(tile);
    ASSERT_TRUE(flat.summary.usable());
    EXPECT_NEAR(testing::perimeter_error(tile, flat.positions), 0.105, 0.003);
    EXPECT_NEAR(testing::area_error(tile, flat.positions), -0.004, 0.001);
}

TEST(Arap, GivesAnOctantItsKnownErrors) {
    const Tile tile = make_tile("octant", testing::octant(32));
    const Flattening flat = flatten_arap(tile);
    ASSERT_TRUE(flat.summary.usable());
    EXPECT_NEAR(testing::perimeter_error(tile, flat.positions), 0.049, 0.002);
    EXPECT_NEAR(testing::area_error(tile, flat.positions), -0.001, 0.001);
}

TEST(Arap, GivesAGoreTheErrorOfTheTheory) {
    // Free boundary: the perimeter of a gore of angle β is too long by β² / 24, to fourth order in β.
    const double angle = 2 * std::numbers::pi / 24;
    const Tile tile = make_tile("gore", testing::lune(angle, 8, 96));
    const Flattening flat = flatten_arap(tile);
    EXPECT_NEAR(testing::perimeter_error(tile, flat.positions), angle * angle / 24, 0.1 * angle * angle / 24);
}

TEST(Arap, FlipsNothingOnGentlyCurvedTiles) {
    for (const auto& shape : testing::curved_shapes()) {
        SCOPED_TRACE(shape.name);
        const Flattening flat = flatten_arap(make_tile(shape.name, shape.mesh));
        EXPECT_EQ(flat.summary.termination, Termination::converged) << flat.summary.text();
        EXPECT_EQ(count_flipped(shape.mesh.triangles, flat.positions), 0);
    }
}

TEST(Arap, DoesNotCareHowVerticesAreNumberedOrWhereTheTileStands) {
    TileOptions options;
    options.warp = Vec3(0.2, 0.5, 1);  // given, because a round cap has no longest axis
    for (const auto& shape : testing::curved_shapes()) {
        SCOPED_TRACE(shape.name);
        const Points2 plain = flatten_arap(make_tile(shape.name, shape.mesh, options)).positions;
        std::vector<int> order;
        const TriangleMesh shuffled = testing::shuffled(shape.mesh, 7, &order);
        const Points2 numbered = flatten_arap(make_tile(shape.name, shuffled, options)).positions;
        EXPECT_LT(testing::distance_up_to_half_turn(numbered, plain(order, Eigen::all)), 1e-9);
    }
    const TriangleMesh gore = testing::lune(std::numbers::pi / 6, 8, 48);
    const Points2 plain = flatten_arap(make_tile("gore", gore)).positions;
    const Points2 moved = flatten_arap(make_tile("gore", testing::moved(gore))).positions;
    EXPECT_LT(testing::distance_up_to_half_turn(moved, plain), 1e-9);
}

TEST(Arap, SaysThatItWasStoppedByTheLimit) {
    const Tile tile = make_tile("octant", testing::octant(8));
    const Flattening flat = flatten_arap(tile, {.max_iterations = 2});
    EXPECT_EQ(flat.summary.termination, Termination::iteration_limit);
    EXPECT_EQ(flat.summary.iterations, 2);
}

TEST(Arap, CountsTheTrianglesItLeavesFlipped) {
    const Tile tile = make_tile("square", testing::rectangle(1, 1, 4, 4));
    Points2 start = tile.mesh.positions.leftCols<2>();
    start.row(12) << 5, 5;  // the middle vertex, moved out of the square
    const Flattening flat = flatten_arap(tile, start, {.max_iterations = 0});
    EXPECT_THAT(flat.summary.reason, ::testing::HasSubstr(" triangles flipped"));
}

TEST(Arap, RefusesAStartOfAnotherMeshAndBadOptions) {
    const Tile tile = make_tile("square", testing::rectangle(1, 1, 4, 4));
    EXPECT_THROW(flatten_arap(tile, Points2::Zero(3, 2)), InputError);
    EXPECT_THROW(flatten_arap(tile, {.tolerance = 0}), InputError);
    EXPECT_THROW(flatten_arap(tile, {.max_iterations = -1}), InputError);
}

}  // namespace arap_test
}  // namespace ripstop
