#include "ripstop/flatten/weave/aono.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "ripstop/base/error.h"
#include "ripstop/measure/measure_accuracy.h"
#include "ripstop/tile/make_tile.h"
#include "support/flat_errors.h"
#include "support/shapes.h"

namespace ripstop {
namespace aono_test {

TEST(Aono, IsExactOnDevelopables) {
    for (const auto& shape : testing::developable_shapes()) {
        const Flattening flat = flatten_aono(make_tile(shape.name, shape.mesh));
        EXPECT_EQ(flat.summary.termination, Termination::converged) << shape.name << flat.summary.text();
        // the cells of the tangent developable between two rulings are not quite flat
        EXPECT_LT(testing::worst_edge_error(shape.mesh, flat.positions), 1e-8) << shape.name;
    }
}

TEST(Aono, ThreadsKeepTheirLengthAndShearAsTheSphereDemands) {
    // On a surface of curvature K, the angle of a Chebyshev net changes by K u v at the place (u, v): by K a^2 in
    // the corner of a square. Vertices are interpolated from crossings within two spacings, so the last triangle
    // has about a tenth less.
    const double a = 0.3;
    const Tile tile = make_tile("square", testing::spherical_square(a, 24), {.warp = Vec3::UnitX()});
    const Accuracy found = measure_accuracy(tile, flatten_aono(tile).positions, Fabric{});
    EXPECT_NEAR(found.shear_max, a * a, 0.12 * a * a);
    for (const double strain :
         {found.warp_strain_min, found.warp_strain_max, found.weft_strain_min, found.weft_strain_max})
        EXPECT_LT(std::abs(strain), 0.004);
}

TEST(Aono, QuarterSphereHasErrorsOfTheOrderThatThePaperPrints) {
    // for it, the paper prints area 1.93 % and shape 14.01 %, by a woven model with little shear resistance; this
    // one has none
    const Tile tile = make_tile("quarter", testing::lune(std::numbers::pi / 2, 16, 32), {.warp = Vec3::UnitZ()});
    const Points2 flat = flatten_aono(tile).positions;
    EXPECT_NEAR(testing::perimeter_error(tile, flat), 0.1401, 0.01);
    EXPECT_NEAR(testing::area_error(tile, flat), 0.0193, 0.005);
}

TEST(Aono, SaysWhereTheNetBreaksDown) {
    // No net of inextensible threads covers much more than a hemisphere: Hazzidakis' bound on the curvature is 2
    // pi.
    const Tile tile = make_tile("sphere", testing::cap(2.6, 16));
    const Flattening flat = flatten_aono(tile);
    EXPECT_EQ(flat.summary.termination, Termination::stagnated) << flat.summary.text();
    EXPECT_NE(flat.summary.reason.find("the net breaks down: threads coincide, first at ("), std::string::npos)
        << flat.summary.text();
    EXPECT_TRUE(flat.positions.allFinite());
}

TEST(Aono, RefusesOptionsOutOfRange) {
    const Tile tile = make_tile("plane", testing::rectangle(1, 1, 2, 2));
    EXPECT_THROW(flatten_aono(tile, {.spacing = 0}), InputError);
    EXPECT_THROW(flatten_aono(tile, {.smallest_angle = 2}), InputError);
}

}  // namespace aono_test
}  // namespace ripstop
