#include "ripstop/measure/measure_bounds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "ripstop/base/text/units.h"
#include "ripstop/tile/make_tile.h"
#include "support/shapes.h"

namespace ripstop {
namespace bounds_test {

Bounds bounds_of(const TriangleMesh& mesh) {
    return measure_bounds(make_tile("t", mesh, {.warp = Vec3(0.3, 0.2, 1)}));
}

TEST(Bounds, APlaneDemandsNothing) {
    const Bounds bounds = bounds_of(testing::rectangle(2, 1, 16, 8));
    EXPECT_NEAR(bounds.isoperimetric, 36 / (8 * std::numbers::pi), 1e-12);
    EXPECT_DOUBLE_EQ(bounds.stretch_ratio, 1);
    EXPECT_NEAR(bounds.radius, 0.5, 0.06);
}

TEST(Bounds, DevelopableAndSaddleTilesDemandNoStretch) {
    EXPECT_LT(bounds_of(testing::cylinder(1, 1.2, 2, 12, 16)).stretch_ratio, 1.0001);
    EXPECT_DOUBLE_EQ(bounds_of(testing::saddle(1, 0.4, 16)).stretch_ratio, 1);
}

TEST(Bounds, FoldedClothDemandsNothing) {
    // an accordion is developable, however short it is in space
    const TriangleMesh mesh = testing::grid(60, 4, [](double u, double v) {
        const int i = static_cast<int>(std::lround(60 * u));
        return Vec3(0.02 * i, 0.5 * v, i % 2 == 0 ? 0 : 0.02);
    });
    EXPECT_LT(bounds_of(mesh).stretch_ratio, 1 + 1e-6);
}

TEST(Bounds, CapDemandsThetaOverItsSine) {
    for (const double theta : {0.4, 0.8}) {
        const Bounds bounds = bounds_of(testing::cap(theta, 24));
        EXPECT_LT(bounds.stretch_ratio, theta / std::sin(theta) * 1.0005);
        EXPECT_GT(bounds.stretch_ratio, 1 + 0.85 * (theta / std::sin(theta) - 1));
    }
}

TEST(Bounds, QuarterSphereSitsOnTheIsoperimetricLimitAndDemandsElevenPerCent) {
    const Bounds bounds = bounds_of(testing::lune(std::numbers::pi / 2, 24, 48));
    EXPECT_NEAR(bounds.isoperimetric, 1, 0.003);
    EXPECT_NEAR(bounds.stretch_ratio, (std::numbers::pi / 4) / std::sin(std::numbers::pi / 4), 0.006);
}

TEST(Bounds, AllowedRatioOfThreadsThatStrainAndShear) {
    EXPECT_NEAR(allowed_stretch_ratio({.strain = 0.02, .shear = 0}), 1.02 / 0.98, 1e-15);
    // a square sheared by 30 degrees without thread strain has the stretches sqrt(1 +- sin 30)
    EXPECT_NEAR(allowed_stretch_ratio({.strain = 0, .shear = 30 * degree}), std::sqrt(1.5 / 0.5), 1e-12);
}

}  // namespace bounds_test
}  // namespace ripstop
