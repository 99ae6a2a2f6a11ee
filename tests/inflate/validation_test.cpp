/// Membranes under gas with known shapes. The meshes and figures are those of docs/methods/inflation.md.
#include <gtest/gtest.h>

#include <cmath>

#include "support/membranes.h"

namespace ripstop {
namespace validation_test {

using namespace testing;

TEST(MembraneUnderGas, SphereGrowsToItsExactRadiusWithTheSquareOfTheEdge) {
    const double coarse = sphere_stretch(8) / sphere_stretch_exact - 1;
    const double fine = sphere_stretch(16) / sphere_stretch_exact - 1;
    EXPECT_LT(std::abs(fine), 6e-5);  // of a stretch by 7e-3: the facets lie inside the sphere
    EXPECT_NEAR(coarse / fine, 4, 1);
}

TEST(MembraneUnderGas, CylinderBearsPressureTimesRadiusRoundIt) {
    const double exact = std::sqrt(1 + 2 * 1200 / balloon_nylon().c11());
    const Cylinder coarse = cylinder_under_gas(16), fine = cylinder_under_gas(32);
    // Chords replace arcs: a fourth of the error at half the edge length.
    EXPECT_NEAR(fine.hoop, 1200, 0.4);
    EXPECT_NEAR((coarse.hoop - 1200) / (fine.hoop - 1200), 4, 0.1);
    EXPECT_NEAR(fine.stretch, exact, 8e-6);
    EXPECT_NEAR((coarse.stretch - exact) / (fine.stretch - exact), 4, 0.1);
}

TEST(MembraneUnderGas, ClampedDiskRisesAsHenckyFound) {
    for (const HenckyRow& exact : hencky) {
        const Disk coarse = clamped_disk(exact.poisson, 16), fine = clamped_disk(exact.poisson, 32);
        // Extrapolated once; the boundary layer converges linearly in the edge length if nu is small.
        EXPECT_NEAR(fine.height + (fine.height - coarse.height) / 3, exact.height, 5e-4) << exact.poisson;
        EXPECT_NEAR(fine.centre + (fine.centre - coarse.centre) / 3, exact.centre, 8e-4) << exact.poisson;
        EXPECT_NEAR(fine.edge + (fine.edge - coarse.edge), exact.edge, 2e-3) << exact.poisson;
    }
}

TEST(MembraneUnderGas, MylarBalloonTakesPaulsensShape) {
    const Mylar found = mylar_balloon(32);
    // The cloth stretches by 0.1 %, and pleats are as wide as triangles: the mesh converges to V like n^-1.3.
    EXPECT_NEAR(found.volume, mylar_exact.volume, 0.005 * mylar_exact.volume);
    EXPECT_NEAR(found.radius, mylar_exact.radius, 0.02 * mylar_exact.radius);
    EXPECT_NEAR(found.half, mylar_exact.half, 0.02 * mylar_exact.half);
}

TEST(MembraneUnderGas, SquareAirbagHasThePublishedHeight) {
    const Airbag found = square_airbag(24);
    EXPECT_NEAR(found.height, 0.2165, 5e-4);
    EXPECT_NEAR(found.corner, 0.0494, 1e-3);
    EXPECT_NEAR(found.volume, 0.2045, 5e-4);
    EXPECT_NEAR(found.tension, 2320, 0.02 * 2320);
}

TEST(MembraneUnderGas, ResidualStiffnessIsTooSmallToMatter) {
    const Airbag soft = square_airbag(12, 1e-6), usual = square_airbag(12, 1e-4);
    // Paulsen's shape gains 0.14 % of volume from 1e-4 to 1e-5 on any mesh.
    EXPECT_NEAR(usual.height, soft.height, 2e-3 * soft.height);
    EXPECT_NEAR(usual.volume, soft.volume, 2e-3 * soft.volume);
}

}  // namespace validation_test
}  // namespace ripstop
