#include "ripstop/flatten/map/dirichlet.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "ripstop/base/error.h"
#include "ripstop/energy/symmetric_dirichlet.h"
#include "ripstop/flatten/map/arap.h"
#include "ripstop/geometry/triangle.h"
#include "ripstop/mesh/change/flips.h"
#include "ripstop/tile/make_tile.h"
#include "support/flat_errors.h"
#include "support/shapes.h"

namespace ripstop {
namespace dirichlet_test {

double energy_of(const TriangleMesh& mesh, const Points2& flat) {
    double sum = 0;
    for (int t = 0; t < mesh.triangle_count(); ++t)
        sum += symmetric_dirichlet_energy(lay_flat(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)),
                                          flat_edges(mesh.triangles, flat, t));
    return sum;
}

TEST(Dirichlet, IsExactOnDevelopables) {
    for (const auto& shape : testing::developable_shapes()) {
        const Flattening flat = flatten_dirichlet(make_tile(shape.name, shape.mesh));
        ASSERT_EQ(flat.summary.termination, Termination::converged) << shape.name << flat.summary.text();
        // the cells of the tangent developable between two rulings are not quite flat
        EXPECT_LT(testing::worst_edge_error(shape.mesh, flat.positions), 1e-8) << shape.name;
    }
}

TEST(Dirichlet, TurnsNothingOverOnTilesThatOthersFold) {
    // a nearly closed sphere, a crumpled sheet, slivers: Tutte's start has no flip, and no step causes one
    std::vector<TriangleMesh> meshes = {testing::lune(std::numbers::pi / 2, 12, 24), testing::octant(12),
                                        testing::cap(2.5, 12), testing::rectangle(20, 1, 10, 20)};
    TriangleMesh crumpled = testing::rectangle(1, 1, 12, 12);
    std::mt19937 random(3);
    std::normal_distribution<double> normal(0, 0.2);
    for (int v = 0; v < crumpled.vertex_count(); ++v) crumpled.positions(v, 2) += normal(random);
    meshes.push_back(crumpled);
    for (const TriangleMesh& mesh : meshes) {
        const Flattening flat = flatten_dirichlet(make_tile("tile", mesh));
        EXPECT_EQ(flat.summary.termination, Termination::converged) << mesh.vertex_count() << flat.summary.text();
        EXPECT_EQ(count_flipped(mesh.triangles, flat.positions), 0);
        EXPECT_LT(flat.summary.iterations, 60);
    }
}

TEST(Dirichlet, LiesBelowArapInItsOwnEnergyAndInNoOther) {
    for (const auto& shape : testing::curved_shapes()) {
        const Tile tile = make_tile(shape.name, shape.mesh);
        EXPECT_LT(energy_of(shape.mesh, flatten_dirichlet(tile).positions),
                  energy_of(shape.mesh, flatten_arap(tile).positions))
            << shape.name;
    }
}

TEST(Dirichlet, FreeGoreIsAsMuchTooLongAsGeometryDemands) {
    // any good free flattening of a gore of angle b: perimeter + b^2 / 24, area exact to a higher order
    const double beta = 2 * std::numbers::pi / 24;
    const Tile tile = make_tile("gore", testing::lune(beta, 8, 96));
    const Points2 flat = flatten_dirichlet(tile).positions;
    EXPECT_NEAR(testing::perimeter_error(tile, flat), beta * beta / 24, 0.15 * beta * beta / 24);
    EXPECT_LT(std::abs(testing::area_error(tile, flat)), 5e-4);
}

TEST(Dirichlet, SaysThatItWasStoppedByTheLimit) {
    const Tile tile = make_tile("octant", testing::octant(8));
    const Flattening flat = flatten_dirichlet(tile, {.max_iterations = 2});
    EXPECT_EQ(flat.summary.termination, Termination::iteration_limit);
    EXPECT_EQ(count_flipped(tile.mesh.triangles, flat.positions), 0);
    EXPECT_THROW(flatten_dirichlet(tile, {.max_iterations = -1}), InputError);
    EXPECT_THROW(flatten_dirichlet(tile, {.tolerance = 0}), InputError);
}

}  // namespace dirichlet_test
}  // namespace ripstop
