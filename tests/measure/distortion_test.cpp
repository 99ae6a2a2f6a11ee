#include "ripstop/measure/distortion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "ripstop/io/mesh/obj.h"
#include "ripstop/measure/overlap.h"
#include "support/shapes.h"
#include "support/shared_data.h"

namespace ripstop {
namespace distortion_test {

/// The singular values of the map surface -> cloth, as in the fixtures.
struct Fixture {
    std::vector<TriangleDistortion> distortion;
    std::size_t overlaps = 0;
    int flipped() const {
        return static_cast<int>(
            std::count_if(distortion.begin(), distortion.end(), [](const auto& d) { return d.flipped; }));
    }
    double largest(std::size_t t) const { return 1 / distortion[t].stretch_min; }
    double smallest(std::size_t t) const { return 1 / distortion[t].stretch_max; }
};

Fixture read(const std::filesystem::path& file) {
    std::ifstream in(file);
    const NamedMesh surface = read_obj(in, file.filename().string()).surfaces.front();
    if (!surface.drawn) throw std::runtime_error("no vt");
    return {measure_distortion(surface.mesh, *surface.drawn),
            overlapping_triangles(surface.mesh.triangles, *surface.drawn).size()};
}

#define EXPECT_ALL_STRETCHED(fixture, high, low)                          \
    for (std::size_t t = 0; t < (fixture).distortion.size(); ++t) {       \
        EXPECT_DOUBLE_EQ((fixture).largest(t), high) << "triangle " << t; \
        EXPECT_DOUBLE_EQ((fixture).smallest(t), low) << "triangle " << t; \
    }

TEST(DistortionFixtures, SquareIsUndistorted) {
    RIPSTOP_REQUIRE_SHARED(file, "uv_fixtures/square.obj");
    const Fixture fixture = read(file);
    EXPECT_ALL_STRETCHED(fixture, 1.0, 1.0);
    EXPECT_EQ(fixture.flipped(), 0);
    EXPECT_EQ(fixture.overlaps, 0u);
}

TEST(DistortionFixtures, ScaledSquareShrinksToAFifth) {
    RIPSTOP_REQUIRE_SHARED(file, "uv_fixtures/square_scaled.obj");
    EXPECT_ALL_STRETCHED(read(file), 0.2, 0.2);
}

TEST(DistortionFixtures, StretchedSquareDoublesOneWay) {
    RIPSTOP_REQUIRE_SHARED(file, "uv_fixtures/square_stretched.obj");
    const Fixture fixture = read(file);
    EXPECT_ALL_STRETCHED(fixture, 2.0, 1.0);
    for (const auto& d : fixture.distortion) {
        EXPECT_DOUBLE_EQ(d.warp_strain, -0.5);  // twice too long on the cloth, so it must shrink
        EXPECT_NEAR(d.weft_strain, 0, 1e-15);
        EXPECT_DOUBLE_EQ(d.area_ratio, 2.0);
    }
}

TEST(DistortionFixtures, TriangleHasStretchOneAndAHalf) {
    RIPSTOP_REQUIRE_SHARED(file, "uv_fixtures/triangle.obj");
    EXPECT_ALL_STRETCHED(read(file), 1.5, 1.0);
}

TEST(DistortionFixtures, FlippedTriangleIsOneFlip) {
    RIPSTOP_REQUIRE_SHARED(file, "uv_fixtures/flipped_tri.obj");
    EXPECT_EQ(read(file).flipped(), 1);
}

TEST(DistortionFixtures, FoldedHasHalfItsTrianglesFlippedAndOneOverlap) {
    RIPSTOP_REQUIRE_SHARED(file, "uv_fixtures/folded.obj");
    const Fixture fixture = read(file);
    EXPECT_EQ(fixture.flipped() * 2, static_cast<int>(fixture.distortion.size()));
    EXPECT_EQ(fixture.overlaps, 1u);
}

TEST(DistortionFixtures, FlatTriangleHasNoAreaOnTheCloth) {
    RIPSTOP_REQUIRE_SHARED(file, "uv_fixtures/flat_triangle.obj");
    const Fixture fixture = read(file);
    EXPECT_EQ(fixture.flipped(), 1);
    EXPECT_TRUE(std::isinf(fixture.distortion[0].stretch_max));
}

TEST(DistortionFixtures, ShiftedColumnsStretchAsTheyWereShifted) {
    RIPSTOP_REQUIRE_SHARED(file, "uv_fixtures/big_left_shift.obj");
    const Fixture fixture = read(file);  // on the cloth the left column is half as wide, the right one 4.5 times
    ASSERT_EQ(fixture.distortion.size(), 8u);
    for (const std::size_t left : {0u, 1u, 4u, 5u}) {
        EXPECT_DOUBLE_EQ(fixture.largest(left), 1.0);
        EXPECT_DOUBLE_EQ(fixture.smallest(left), 0.5);
    }
    for (const std::size_t right : {2u, 3u, 6u, 7u}) {
        EXPECT_DOUBLE_EQ(fixture.largest(right), 4.5);
        EXPECT_DOUBLE_EQ(fixture.smallest(right), 1.0);
    }
}

TEST(Distortion, ShearByHand) {
    const TriangleMesh mesh = testing::rectangle(1, 1, 1, 1);
    Points2 flat(4, 2);
    flat << 0, 0, 1, 0, 0.1, 1, 1.1, 1;  // the cloth leans by atan 0.1; its threads are perpendicular in space
    for (const auto& d : measure_distortion(mesh, flat)) {
        // F = [1 -0.1; 0 1]: warp (1, 0), weft (-0.1, 1)
        EXPECT_NEAR(d.warp_strain, 0, 1e-15);
        EXPECT_NEAR(d.weft_strain, std::sqrt(1.01) - 1, 1e-15);
        EXPECT_NEAR(d.shear, -std::atan(0.1), 1e-15);
        EXPECT_NEAR(d.area_ratio, 1, 1e-15);
    }
}

}  // namespace distortion_test
}  // namespace ripstop
