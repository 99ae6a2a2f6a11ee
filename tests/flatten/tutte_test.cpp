#include "ripstop/flatten/map/tutte.h"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "ripstop/mesh/boundary.h"
#include "ripstop/mesh/change/flips.h"
#include "ripstop/tile/make_tile.h"
#include "support/flat_errors.h"
#include "support/shapes.h"

namespace ripstop {
namespace tutte_test {

void expect_no_flip(const std::string& name, const TriangleMesh& mesh) {
    SCOPED_TRACE(name);
    const Tile tile = make_tile(name, mesh);
    const Flattening flat = flatten_tutte(tile);
    ASSERT_EQ(flat.summary.termination, Termination::converged) << flat.summary.text();
    EXPECT_EQ(count_flipped(mesh.triangles, flat.positions), 0) << flat.summary.text();
    EXPECT_NEAR(testing::area_error(tile, flat.positions), 0, 1e-12);
}

/// A disk of which only the triangles are kept: its inner points are moved far out of the surface.
TriangleMesh crumpled(TriangleMesh mesh, double size) {
    std::mt19937 random(3);
    std::normal_distribution<double> normal(0, size);
    for (int v = 0; v < mesh.vertex_count(); ++v) mesh.positions(v, 2) += normal(random);
    return mesh;
}

TEST(Tutte, FlipsNothing) {
    for (const auto& shapes : {testing::developable_shapes(), testing::curved_shapes()})
        for (const auto& shape : shapes) expect_no_flip(shape.name, shape.mesh);
    expect_no_flip("quarter sphere", testing::lune(std::numbers::pi / 2, 12, 24));
    expect_no_flip("octant", testing::octant(12));
    expect_no_flip("nearly closed sphere", testing::cap(3.0, 16));
    expect_no_flip("crumpled", crumpled(testing::rectangle(1, 1, 20, 20), 1));
}

TEST(Tutte, FlipsNothingAmongNeedlesAndStretchedTriangles) {
    expect_no_flip("1:10", testing::rectangle(10, 1, 20, 20));
    expect_no_flip("10:1", testing::rectangle(1, 10, 20, 20));
    expect_no_flip("1:1000", testing::rectangle(1000, 1, 20, 20));
    TriangleMesh slivers = testing::rectangle(1, 1, 20, 20);
    for (int v = 0; v < slivers.vertex_count(); ++v)  // every second row of points almost coincides with the one before
        if (const int row = v / 21; row % 2 == 1) slivers.positions(v, 1) -= 0.05 * (1 - 1e-4);
    expect_no_flip("slivers 1e-4", slivers);
}

TEST(Tutte, FlipsNothingWhereInnerEdgesJoinBoundaryVertices) {
    expect_no_flip("one triangle a corner", testing::rectangle(1, 1, 1, 1));
    expect_no_flip("a strip, all of it boundary", testing::rectangle(5, 1, 10, 1));
    expect_no_flip("a lune of one column", testing::lune(0.3, 1, 12));
    expect_no_flip("a lune of two columns", testing::lune(0.3, 2, 12));
}

TEST(Tutte, PutsTheBoundaryOnACircleByItsLength) {
    const Tile tile = make_tile("gore", testing::lune(0.5, 4, 24));
    const Flattening flat = flatten_tutte(tile);
    const Eigen::VectorXd lengths = edge_lengths(tile.mesh.positions, closed(tile.boundary));
    const Eigen::VectorXd chords = edge_lengths(flat.positions, closed(tile.boundary));
    const double radius = chords[0] / 2 / std::sin(std::numbers::pi * lengths[0] / lengths.sum());
    for (Eigen::Index i = 0; i < chords.size(); ++i)
        EXPECT_NEAR(chords[i], 2 * radius * std::sin(std::numbers::pi * lengths[i] / lengths.sum()), 1e-12);
}

TEST(Tutte, DoesNotCareHowVerticesAreNumbered) {
    const TriangleMesh mesh = testing::lune(0.5, 4, 24);
    std::vector<int> order;
    const TriangleMesh shuffled = testing::shuffled(mesh, 7, &order);
    const Points2 plain = flatten_tutte(make_tile("gore", mesh)).positions;
    const Points2 numbered = flatten_tutte(make_tile("gore", shuffled)).positions;
    EXPECT_LT(testing::distance_up_to_half_turn(numbered, plain(order, Eigen::all)), 1e-9);
}

}  // namespace tutte_test
}  // namespace ripstop
