/// Tiles that go all the way round and are sewn to themselves.
#include <gtest/gtest.h>

#include <Eigen/SVD>
#include <cmath>
#include <numbers>

#include "ripstop/base/text/number_text.h"
#include "ripstop/flatten/seam/seam_exact.h"
#include "ripstop/measure/measure_accuracy.h"
#include "ripstop/mesh/boundary.h"
#include "ripstop/tile/make_tile.h"
#include "support/closed_tiles.h"
#include "support/fabrics.h"
#include "support/flat_errors.h"
#include "support/shapes.h"

namespace ripstop {
namespace closed_tiles_test {

constexpr double pi = std::numbers::pi;

Fabric stiff() {
    Fabric fabric;
    fabric.warp_stiffness = 90'000;
    fabric.weft_stiffness = 20'000;
    fabric.poisson = 0.05;
    fabric.shear_stiffness = 150;
    return fabric;
}

std::vector<Fabric> cloths() {
    return {testing::cloth(0, 0.5), Fabric{}, stiff()};
}

Flattening flattened(const TriangleMesh& mesh, const Fabric& fabric, const TileOptions& options = {}) {
    return flatten_seam_exact(make_tile("sleeve", mesh, options), fabric);
}

/// Expects the drawn shape back: converged, a proven minimum, each edge as long as in space.
void expect_isometry(const TriangleMesh& mesh, const Fabric& fabric, const TileOptions& options = {}) {
    const Flattening flat = flattened(mesh, fabric, options);
    EXPECT_EQ(flat.summary.termination, Termination::converged) << flat.summary.text();
    ASSERT_TRUE(flat.certificate);
    EXPECT_TRUE(flat.certificate->strict_minimum);
    EXPECT_LE(flat.summary.factorizations, 4) << flat.summary.text();
    // rounding error of an edge, relative to the whole tile
    const double least = edge_lengths(mesh.positions, {mesh.triangles(0, 0), mesh.triangles(0, 1)})[0];
    EXPECT_LT(testing::worst_edge_error(mesh, flat.positions), 1e-11 * bounding_diagonal(mesh) / least + 1e-10);
}

/// The sizes along and across the warp [m].
Vec2 size_of(const Points2& flat) {
    return (flat.colwise().maxCoeff() - flat.colwise().minCoeff()).transpose();
}

TEST(ClosedTiles, RoundTubeCutOpenIsItsRectangleWhateverItsSizeAndCloth) {
    for (const int sides : {3, 4, 5, 6, 8, 12, 24, 48})
        for (const int rows : {1, 2, 4, 8})
            for (const double height : {0.5, 1.0, 2.0, 6.0})
                for (const Fabric& fabric : cloths()) {
                    SCOPED_TRACE(std::to_string(sides) + " sides, " + std::to_string(rows) + " rows, " +
                                 format_shortest(height) + " m");
                    expect_isometry(testing::round_tube(1, height, sides, rows), fabric);
                }
}

TEST(ClosedTiles, BoxTubeConeAndHelicalCutAreIsometricToo) {
    for (const Fabric& fabric : cloths()) {
        for (const double width : {0.3, 1.0, 1.4142135623730951, 4.0})
            for (const int columns : {1, 3}) expect_isometry(testing::box_tube(width, 1, 2, columns, 2), fabric);
        for (const double half : {0.1, 0.3, pi / 6, 0.8, 1.2})
            expect_isometry(testing::cone(half, 2 * pi, 1, 2.5, 24, 4), fabric);
        for (const int slip : {1, 3, 7, 11}) expect_isometry(testing::helical_tube(1, 2, 12, 3, slip), fabric);
    }
}

TEST(ClosedTiles, DoNotCareAboutPoseOrderAndScale) {
    for (const double scale : {1e-3, 1.0, 1e3})
        for (const unsigned seed : {1U, 2U, 3U})
            for (const Fabric& fabric : cloths()) {
                SCOPED_TRACE(scale);
                TriangleMesh mesh = testing::scaled(testing::round_tube(1, 2, 12, 3), scale);
                mesh = testing::shuffled(testing::moved(mesh), seed);
                expect_isometry(mesh, fabric);
            }
}

TEST(ClosedTiles, LieWithTheWarpRoundWhereItIsHorizontalAndAlongWhereItStands) {
    const TriangleMesh tube = testing::round_tube(1, 2, 12, 2);
    const double around = 24 * std::sin(pi / 12);
    for (const double angle : {0.0, 0.3, 1.0, pi / 2}) {
        const Vec2 round =
            size_of(flattened(tube, Fabric{}, {.warp = Vec3(std::cos(angle), std::sin(angle), 0)}).positions);
        EXPECT_NEAR(round.x(), around, 1e-9);
        EXPECT_NEAR(round.y(), 2, 1e-9);
    }
    const Vec2 upright = size_of(flattened(tube, Fabric{}, {.warp = Vec3::UnitZ()}).positions);
    EXPECT_NEAR(upright.x(), 2, 1e-9);
    EXPECT_NEAR(upright.y(), around, 1e-9);
}

TEST(ClosedTiles, ComeToRestWhereTheyBulge) {
    // what remeshing gives for a tube: nearly no strain, and no warp of its own to fix the rotation
    for (const int sides : {12, 24})
        for (const double share : {1e-9, 1e-6, 1e-3, 0.02})
            for (const Fabric& fabric : cloths()) {
                SCOPED_TRACE(std::to_string(sides) + " sides bulging by " + format_shortest(share));
                const TriangleMesh mesh = testing::bulged(testing::round_tube(1, 2, sides, 8), share);
                const Flattening flat = flattened(mesh, fabric);
                EXPECT_EQ(flat.summary.termination, Termination::converged) << flat.summary.text();
                EXPECT_TRUE(flat.certificate && flat.certificate->strict_minimum);
                EXPECT_NEAR(size_of(flat.positions).x(), 2 * sides * std::sin(pi / sides), 2 * pi * share + 1e-9);
            }
}

}  // namespace closed_tiles_test
}  // namespace ripstop
