#include "ripstop/flatten/map/boundary_first.h"

#include <gtest/gtest.h>

#include <cmath>

#include "ripstop/mesh/boundary.h"
#include "ripstop/mesh/change/flips.h"
#include "ripstop/tile/make_tile.h"
#include "ripstop/tile/targets.h"
#include "support/flat_errors.h"
#include "support/shapes.h"

namespace ripstop {
namespace boundary_first_test {

TEST(BoundaryFirst, IsExactOnDevelopables) {
    for (const auto& shape : testing::developable_shapes()) {
        SCOPED_TRACE(shape.name);
        const Tile tile = make_tile(shape.name, shape.mesh);
        const Flattening flat = flatten_boundary_first(tile);
        ASSERT_EQ(flat.summary.termination, Termination::converged) << flat.summary.text();
        // the turning of the outline is a sum over its edges, so their rounding errors add up
        EXPECT_LT(testing::worst_edge_error(shape.mesh, flat.positions), 1e-9);
        EXPECT_EQ(count_flipped(shape.mesh.triangles, flat.positions), 0);
    }
}

TEST(BoundaryFirst, LaysASphericalCapAsTheDiscOfItsOwnRim) {
    // The only conformal disk whose rim keeps its length has the radius sin(theta). Its area error is that of
    // seam-exact cloth, (1 - cos theta) / 2.
    const double theta = 0.6;
    const Tile tile = make_tile("cap", testing::cap(theta, 24));
    const Flattening flat = flatten_boundary_first(tile);
    const Points2 rim = flat.positions(tile.boundary, Eigen::all);
    const Eigen::RowVector2d centre = rim.colwise().mean();
    for (const double radius : (rim.rowwise() - centre).rowwise().norm())
        EXPECT_NEAR(radius, std::sin(theta), 1e-3 * std::sin(theta));
    EXPECT_NEAR(testing::area_error(tile, flat.positions), -(1 - std::cos(theta)) / 2, 2e-3);
}

TEST(BoundaryFirst, KeepsTheEdgesNearlyOnCurvedTiles) {
    for (const auto& shape : testing::curved_shapes()) {
        SCOPED_TRACE(shape.name);
        const Tile tile = make_tile(shape.name, shape.mesh);
        const Flattening flat = flatten_boundary_first(tile);
        ASSERT_TRUE(flat.summary.usable());
        const Eigen::VectorXd lengths = edge_lengths(flat.positions, closed(tile.boundary));
        // the remaining error is the closing gap of the discrete turnings, of the order of the mesh size
        EXPECT_LT((lengths.cwiseQuotient(target_lengths(tile)).array() - 1).abs().maxCoeff(), 0.02);
    }
}

TEST(BoundaryFirst, FlattensATileWithoutVerticesInside) {
    const Tile tile = make_tile("strip", testing::cylinder(1, 0.5, 0.2, 8, 1));
    const Flattening flat = flatten_boundary_first(tile);
    EXPECT_LT(testing::worst_edge_error(tile.mesh, flat.positions), 1e-12);
}

}  // namespace boundary_first_test
}  // namespace ripstop
