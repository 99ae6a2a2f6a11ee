#include "ripstop/flatten/spring/mccartney.h"

#include <gtest/gtest.h>

#include <cmath>

#include "ripstop/base/error.h"
#include "ripstop/measure/measure_accuracy.h"
#include "ripstop/tile/make_tile.h"
#include "support/flat_errors.h"
#include "support/shapes.h"

namespace ripstop {
namespace mccartney_test {

TEST(McCartney, LaysDevelopablesExactly) {
    for (const auto& shape : testing::developable_shapes())
        for (const bool woven : {false, true}) {
            const Flattening flat = flatten_mccartney(make_tile(shape.name, shape.mesh), Fabric{}, {.woven = woven});
            EXPECT_EQ(flat.summary.termination, Termination::converged) << shape.name;
            // the cells of the tangent developable between two rulings are not quite flat
            EXPECT_LT(testing::worst_edge_error(shape.mesh, flat.positions), 1e-8) << shape.name;
        }
}

TEST(McCartney, OctantComesToTheMinimumOfItsSprings) {
    // The minimum of edge springs on an octant, as published by others who used Newton's method: perimeter +4.1 %,
    // area -1 %.
    const Tile tile = make_tile("octant", testing::octant(16));
    const Flattening flat = flatten_mccartney(tile, Fabric{});
    EXPECT_EQ(flat.summary.termination, Termination::converged) << flat.summary.text();
    EXPECT_NEAR(testing::perimeter_error(tile, flat.positions), 0.041, 0.006);
    EXPECT_NEAR(testing::area_error(tile, flat.positions), -0.0095, 0.005);
}

TEST(McCartney, WovenEnergyFollowsTheFabric) {
    const Tile tile = make_tile("square", testing::spherical_square(0.4, 10), {.warp = Vec3::UnitX()});
    Fabric stiff;
    stiff.shear_stiffness = 5000;
    Fabric soft;
    soft.shear_stiffness = 5;
    const auto flattened = [&](const Fabric& fabric, bool woven) {
        return measure_accuracy(tile, flatten_mccartney(tile, fabric, {.woven = woven}).positions, fabric);
    };
    // threads that may rotate keep their length
    EXPECT_LT(flattened(soft, true).warp_strain_max, 0.5 * flattened(stiff, true).warp_strain_max);
    EXPECT_GT(flattened(soft, true).shear_max, 1.5 * flattened(stiff, true).shear_max);
    // the energy of the woven membrane is also lower than that of the plain method, which ignores the fabric
    EXPECT_LT(flattened(soft, true).energy, flattened(soft, false).energy);
    EXPECT_EQ(flattened(soft, false).area_error, flattened(stiff, false).area_error);
}

TEST(McCartney, SaysThatItWasStoppedByTheLimitAndRefusesBadOptions) {
    const Tile tile = make_tile("octant", testing::octant(8));
    const Flattening flat = flatten_mccartney(tile, Fabric{}, {.max_sweeps = 3});
    EXPECT_EQ(flat.summary.termination, Termination::iteration_limit);
    EXPECT_EQ(flat.summary.iterations, 3);
    EXPECT_THROW(flatten_mccartney(tile, Fabric{}, {.first_move = 0}), InputError);
    EXPECT_THROW(flatten_mccartney(tile, Fabric{}, {.last_move = 1}), InputError);
    EXPECT_THROW(flatten_mccartney(tile, Fabric{}, {.max_sweeps = -1}), InputError);
}

}  // namespace mccartney_test
}  // namespace ripstop
