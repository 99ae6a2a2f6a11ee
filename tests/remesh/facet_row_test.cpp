#include "ripstop/remesh/facet_row.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "ripstop/assembly/seams/chain_curve.h"
#include "ripstop/tile/make_tile.h"
#include "support/poor_meshes.h"
#include "support/shapes.h"

namespace ripstop {
namespace facet_row_test {

using namespace testing;
using std::numbers::pi;

BoundarySlopes slopes_of(const Tile& tile) {
    const Eigen::Index size = static_cast<Eigen::Index>(tile.boundary.size());
    BoundarySlopes slopes{Points3::Zero(size, 3), Points3::Zero(size, 3)};
    for (const Chain& chain : tile.chains) {
        const ChainCurve curve = make_chain_curve(tile, chain);
        for (int e = 0; e < curve.edge_count(); ++e)
            for (Eigen::Index i = 0; i < size; ++i)
                if (tile.boundary[static_cast<std::size_t>(i)] == chain.vertices[static_cast<std::size_t>(e)]) {
                    slopes.start.row(i) = curve.start_slopes.row(e);
                    slopes.end.row(i) = curve.end_slopes.row(e);
                }
    }
    return slopes;
}

/// The row of a tile and the data it refers to.
struct Found {
    Tile tile;
    std::optional<FacetRow> row;
    explicit Found(const TriangleMesh& mesh) : tile(make_tile("tile", mesh, {.warp = Vec3(0.1, 0.2, 1)})) {
        row = FacetRow::find(tile, Adjacency(tile.mesh.triangles, tile.mesh.vertex_count()), slopes_of(tile));
    }
};

/// The largest distance from a cylinder about the z axis, at the midpoints of triangles and edges.
double off_the_cylinder(const Found& found, double radius) {
    double worst = 0;
    for (int t = 0; t < found.tile.mesh.triangle_count(); ++t)
        for (const Vec3& weights : {Vec3(1, 1, 1), Vec3(1, 1, 0), Vec3(0, 1, 1), Vec3(1, 0, 1)}) {
            const Vec3 at = found.row->at({t, weights / weights.sum()});
            worst = std::max(worst, std::abs(at.head<2>().norm() - radius));
        }
    return worst;
}

TEST(FacetRow, OfACylinderIsTheCylinderWithAnyNumberOfQuadsAcross) {
    for (const int across : {1, 2, 5})
        for (const int along : {6, 12}) {
            const Found found(cylinder(1, pi, 0.5, along, across));
            ASSERT_TRUE(found.row) << along << " x " << across;
            EXPECT_EQ(found.row->cell_count(), along);
            const double turn = pi / along;
            EXPECT_LT(off_the_cylinder(found, 1), 1e-3 * std::pow(turn, 4));  // the facets are t² / 8 inside
        }
}

TEST(FacetRow, OfASlantedStrapIsTheCylinderToo) {
    const Found found(
        grid(10, 1, [](double u, double v) { return Vec3(std::cos(pi * u), std::sin(pi * u), u + 0.2 * v); }));
    ASSERT_TRUE(found.row);
    EXPECT_LT(off_the_cylinder(found, 1), 1e-3);  // the helix is accurate to fourth order: t^4 = 0.0097
}

TEST(FacetRow, OfAConeAndItsTipLiesOnTheCone) {
    // z| = r / tan(0.4): a fan around the tip, and bands below it.
    TriangleMesh fan;
    fan.positions.resize(10, 3);
    fan.triangles.resize(8, 3);
    fan.positions.row(0).setZero();
    for (int i = 0; i <= 8; ++i)
        fan.positions.row(i + 1) << std::sin(0.4) * std::cos(pi * i / 8), std::sin(0.4) * std::sin(pi * i / 8),
            std::cos(0.4);
    for (int i = 0; i < 8; ++i) fan.triangles.row(i) << 0, i + 1, i + 2;
    for (const TriangleMesh& mesh : {fan, cone(0.4, 2, 0.3, 1, 8, 1), cone(0.4, 2, 0.3, 1, 8, 3)}) {
        const Found found(mesh);
        ASSERT_TRUE(found.row);
        for (double along = 0.05; along < found.row->cell_count(); along += 0.3)
            for (const double across : {0.1, 0.5, 0.9}) {
                const Vec3 at = found.row->at(along, across);
                EXPECT_NEAR(at.head<2>().norm() / std::abs(at.z()), std::tan(0.4), 1e-4);
            }
    }
}

TEST(FacetRow, OfSkewQuadsIsRuledBetweenBothSides) {
    // Tangents of a helix: quads between them are not flat, whichever diagonal divides them.
    const Found found(tangent_developable(0.5, 0.4, 1.6, 0.1, 0.8, 8, 4));
    ASSERT_TRUE(found.row);
    EXPECT_EQ(found.row->cell_count(), 8);
    for (double along = 0; along <= 8; along += 0.4) {
        const double t = 1.6 * along / 8, c = std::hypot(0.5, 0.4);
        for (const double across : {0.0, 0.5, 1.0}) {
            const double v0 = 0.1 + 0.7 * across, v1 = 0.1 + 0.7 * (1 - across);
            const auto on = [&](double s, double v) {
                return Vec3(0.5 * std::cos(s) - v * 0.5 * std::sin(s) / c,
                            0.5 * std::sin(s) + v * 0.5 * std::cos(s) / c, 0.4 * s + v * 0.4 / c);
            };
            // The row may begin at either end of the surface.
            const Vec3 at = found.row->at(along, across);
            double nearest = 1;
            for (const double v : {v0, v1})
                for (const double s : {t, 1.6 - t}) nearest = std::min(nearest, (at - on(s, v)).norm());
            EXPECT_LT(nearest, 2e-3) << along << " " << across;  // t^4 divided by some; the chords are 5e-3 off
        }
    }
}

TEST(FacetRow, IsNoneWhereTheSurfaceBendsBothWays) {
    EXPECT_FALSE(Found(octant(4)).row);
    EXPECT_FALSE(Found(sphere_grid(0.3, 6, 6)).row);
    EXPECT_FALSE(Found(saddle(1, 0.5, 6)).row);
    EXPECT_FALSE(Found(lune(1, 2, 8)).row);
    EXPECT_FALSE(Found(torus_patch(3, 1, 0.5, 2.6, 3.7, 6, 2)).row);
    EXPECT_FALSE(Found(staggered_cone(0.4, 2, 0.3, 1, 8, 3)).row);
}

TEST(FacetRow, BeginsAndEndsAtItsCornersAndKeepsItsCreases) {
    const Found found(cylinder(1, 2, 0.5, 6, 1));
    ASSERT_TRUE(found.row);
    for (int k = 0; k <= 6; ++k)
        for (const double across : {0.0, 0.3, 1.0})
            EXPECT_LT((found.row->at(k, across) - found.row->faceted_at(k, across)).norm(), 1e-12);
    const std::array<int, 4>& corners = found.row->corners();
    EXPECT_NEAR(*found.row->along_a({corners[0], 0}), 0, 1e-12);
    EXPECT_NEAR(*found.row->along_a({corners[1], 0}), 6, 1e-12);
    EXPECT_NEAR(*found.row->along_b({corners[2], 0}), 6, 1e-12);
    EXPECT_NEAR(*found.row->along_b({corners[3], 0}), 0, 1e-12);
    EXPECT_NEAR(*found.row->along_a({corners[0], 0.25}), 0.25, 1e-12);
}

}  // namespace facet_row_test
}  // namespace ripstop
