#include "ripstop/flatten/spring/energy_release.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "ripstop/base/error.h"
#include "ripstop/measure/measure_accuracy.h"
#include "ripstop/tile/make_tile.h"
#include "support/flat_errors.h"
#include "support/shapes.h"

namespace ripstop {
namespace energy_release_test {

TEST(EnergyRelease, LaysDevelopablesExactlyWithoutReleasing) {
    for (const auto& shape : testing::developable_shapes()) {
        const Flattening flat = flatten_energy_release(make_tile(shape.name, shape.mesh));
        EXPECT_EQ(flat.summary.iterations, 0) << shape.name;
        // the cells of the tangent developable between two rulings are not quite flat
        EXPECT_LT(testing::worst_edge_error(shape.mesh, flat.positions), 1e-8) << shape.name;
    }
}

TEST(EnergyRelease, OctantIsNearThePublishedErrors) {
    // Wang, Tang, Yeung 2005, table of results, print for it: boundary 4.84 %, area 0.91 %, both net
    const Tile tile = make_tile("octant", testing::octant(24));
    const Flattening flat = flatten_energy_release(tile);
    EXPECT_EQ(flat.summary.termination, Termination::converged) << flat.summary.text();
    const Accuracy found = measure_accuracy(tile, flat.positions, Fabric{});
    EXPECT_EQ(found.flipped, 0);
    EXPECT_GT(found.perimeter_error, 0.040);
    EXPECT_LT(found.perimeter_error, 0.0484);
    EXPECT_GT(found.area_error, -0.012);
    EXPECT_LT(found.area_error, -0.007);
}

TEST(EnergyRelease, ConeIsOfTheOrderOfThePublishedErrors) {
    // printed for a conical surface of 149 triangles: area 0.092 %, edges 0.174 %; this mesh has 144 and is not
    // ruled
    const Tile tile = make_tile("cone", testing::staggered_cone(0.4, 2.4, 0.5, 2, 12, 6));
    const Accuracy found = measure_accuracy(tile, flatten_energy_release(tile).positions, Fabric{});
    EXPECT_LT(found.area_error_abs, 0.0015);
    EXPECT_LT(found.edge_error_abs, 0.00174);
}

TEST(EnergyRelease, ReleasesOnlyWhatIsWorseThanTheAccuracy) {
    const Tile tile = make_tile("cap", testing::cap(0.4, 8));
    EXPECT_EQ(flatten_energy_release(tile, {.accuracy = 0.2}).summary.iterations, 0);
    const Flattening fine = flatten_energy_release(tile, {.accuracy = 1e-4});
    EXPECT_GT(fine.summary.iterations, 10);
    EXPECT_LT(
        measure_accuracy(tile, fine.positions, Fabric{}).edge_error_abs,
        measure_accuracy(tile, flatten_energy_release(tile, {.accuracy = 0.2}).positions, Fabric{}).edge_error_abs);
}

TEST(EnergyRelease, PushesATriangleOpenThatWasTurnedOver) {
    // a strip around half a sphere meets itself while it is laid out
    const Tile tile = make_tile("hemisphere", testing::cap(1.5, 10));
    const Flattening flat = flatten_energy_release(tile);
    EXPECT_EQ(measure_accuracy(tile, flat.positions, Fabric{}).flipped, 0) << flat.summary.text();
}

TEST(EnergyRelease, SaysThatItWasStoppedByTheLimitAndRefusesBadOptions) {
    const Tile tile = make_tile("octant", testing::octant(8));
    EXPECT_EQ(flatten_energy_release(tile, {.max_steps = 1}).summary.termination, Termination::iteration_limit);
    EXPECT_THROW(flatten_energy_release(tile, {.accuracy = 0}), InputError);
    EXPECT_THROW(flatten_energy_release(tile, {.step = 2}), InputError);
    EXPECT_THROW(flatten_energy_release(tile, {.max_steps = -1}), InputError);
}

}  // namespace energy_release_test
}  // namespace ripstop
