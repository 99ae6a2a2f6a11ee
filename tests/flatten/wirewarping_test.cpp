#include "ripstop/flatten/map/wirewarping.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "ripstop/base/error.h"
#include "ripstop/mesh/boundary.h"
#include "ripstop/tile/make_tile.h"
#include "ripstop/tile/targets.h"
#include "support/flat_errors.h"
#include "support/shapes.h"

namespace ripstop {
namespace wirewarping_test {

double worst_outline_error(const Tile& tile, const Points2& flat) {
    const Eigen::VectorXd lengths = edge_lengths(flat, closed(tile.boundary));
    return (lengths.cwiseQuotient(target_lengths(tile)).array() - 1).abs().maxCoeff();
}

TEST(WireWarping, KeepsEveryEdgeOfTheOutline) {
    for (const auto& shapes : {testing::developable_shapes(), testing::curved_shapes()})
        for (const auto& shape : shapes) {
            const Tile tile = make_tile(shape.name, shape.mesh);
            const Flattening flat = flatten_wirewarping(tile);
            ASSERT_EQ(flat.summary.termination, Termination::converged) << shape.name << flat.summary.text();
            // by construction, except for the last edge, which takes the closing error
            EXPECT_LT(worst_outline_error(tile, flat.positions), 1e-9) << shape.name;
        }
}

TEST(WireWarping, OutlineIsExactOnDevelopables) {
    for (const auto& shape : testing::developable_shapes()) {
        const Tile tile = make_tile(shape.name, shape.mesh);
        // the cells of the tangent developable between two rulings are not quite flat
        EXPECT_LT(std::abs(testing::area_error(tile, flatten_wirewarping(tile).positions)), 1e-8) << shape.name;
    }
}

TEST(WireWarping, MakesALensOfAnyGore) {
    // Equal edges share the change of turning, the integral of the curvature, evenly: geodesic seams become arcs
    // that turn by b each. The half width is b s (pi - s) / (2 pi) and the area b pi^2 / 6, compared with the
    // sphere's 2 b: pi^2 / 12 - 1 for any b.
    const double lens = std::numbers::pi * std::numbers::pi / 12 - 1;
    for (const int gores : {12, 24, 48})
        for (const int columns : {4, 16}) {
            // The outermost vertices of a mesh carry half a column of the curvature each, which correctly turns
            // with the latitude; the lens consists of the rest.
            const double expected = lens * (1 - 1.0 / columns);
            const Tile tile = make_tile("gore", testing::lune(2 * std::numbers::pi / gores, columns, 200));
            const Points2 flat = flatten_wirewarping(tile).positions;
            // 0.1 % from the mesh; the closed form is for a narrow gore
            EXPECT_NEAR(testing::area_error(tile, flat), expected, 0.001 + 2.0 / gores / gores) << gores;
        }
}

TEST(WireWarping, FindsTheNearestTurningsOfAWireThatIsOpen) {
    // A square that should turn by 1 and 2.2 rad alternately: by symmetry the turns become 1 and 2.2 minus the
    // same amount, a rhombus.
    Eigen::VectorXd wanted(4);
    wanted << 1, 2.2, 1, 2.2;
    const ClosedWire wire = warp_wire(Eigen::VectorXd::Ones(4), wanted);
    EXPECT_TRUE(wire.closed);
    EXPECT_FALSE(wire.minimum_norm);
    const double excess = (6.4 - 2 * std::numbers::pi) / 4;
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(wire.turning[i], wanted[i] - excess, 1e-9);
}

TEST(WireWarping, SaysWhereNoLineOfTheseLengthsCloses) {
    const Eigen::Vector3d lengths(1, 1, 3);
    EXPECT_FALSE(warp_wire(lengths, Eigen::Vector3d::Constant(2)).closed);
    EXPECT_THROW(warp_wire(lengths, Eigen::Vector2d(1, 2)), InputError);
    EXPECT_THROW(warp_wire(lengths, lengths, {.max_iterations = 0}), InputError);
}

}  // namespace wirewarping_test
}  // namespace ripstop
