#include "ripstop/remesh/mesh_state.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "ripstop/tile/make_tile.h"
#include "support/poor_meshes.h"
#include "support/shapes.h"

namespace ripstop {
namespace mesh_state_test {

using namespace testing;
using ::testing::HasSubstr;

MeshState state_of(const TriangleMesh& mesh) {
    return measure_mesh(make_tile("tile", mesh, {.warp = Vec3(0.1, 0.2, 1)}));
}

TEST(MeshState, KnowsTheTurnsAndTheCurvatureOfACylinder) {
    const MeshState state = state_of(cylinder(2, 1, 1.5, 20, 6));
    EXPECT_NEAR(state.boundary_turn, 1.0 / 20, 1e-9);
    EXPECT_NEAR(state.turn_max, 1.0 / 20, 1e-9);
    EXPECT_NEAR(state.curvature, 0.5 * 19 / 20, 1e-3);  // the edges of 19 of its 20 strips turn
}

TEST(MeshState, ACoarseBoundaryIsAFaultFromHalfTheTolerance) {
    // t^2 / 24 = 0.001 / 2 at 6.28 degrees.
    EXPECT_FALSE(find_fault(state_of(cylinder(2, 6.1 * 8 * degree, 1, 8, 6)), 0.001));
    const auto fault = find_fault(state_of(cylinder(2, 6.45 * 8 * degree, 1, 8, 6)), 0.001);
    ASSERT_TRUE(fault);
    EXPECT_EQ(fault->kind, MeshFault::turns);
    EXPECT_EQ(fault->text(), "edges turn by up to 6 degrees");
    EXPECT_FALSE(find_fault(state_of(cylinder(2, 6.45 * 8 * degree, 1, 8, 6)), 0.002));
}

TEST(MeshState, SliversAndLockedEdgesAndTooManyTrianglesAreFaults) {
    EXPECT_EQ(find_fault(state_of(sphere_grid(0.3, 300, 12)), 0.001)->kind, MeshFault::slivers);
    EXPECT_EQ(find_fault(state_of(cylinder(2, 0.5, 0.1, 20, 1)), 0.001)->kind, MeshFault::locked);
    EXPECT_EQ(find_fault(state_of(sphere_grid(0.3, 168, 168)), 0.001)->kind, MeshFault::too_fine);
}

TEST(MeshState, AFlatTileIsNeverWorthIt) {
    EXPECT_FALSE(find_fault(state_of(rectangle(4, 1, 1, 1)), 0.001));
    EXPECT_FALSE(find_fault(state_of(rectangle(4, 0.01, 1, 300)), 0.001));
}

TEST(MeshState, TheNeededEdgeGivesFiveDegreesWithinAThousandToFourThousandTriangles) {
    const MeshState flat = state_of(rectangle(4, 1, 8, 2));
    EXPECT_NEAR(flat.area / (std::sqrt(3.0) / 4 * std::pow(needed_edge(flat), 2)), 1000, 1e-6);
    // Two curvatures of 1: the turns of a sphere's triangles, over its area, sum to about 2.
    EXPECT_NEAR(needed_edge(state_of(octant(48))), 5 * degree / 2, 0.2 * 5 * degree / 2);
    const MeshState crumpled = state_of(lune(std::numbers::pi, 4, 4));
    EXPECT_GE(needed_edge(crumpled), edge_of(crumpled.area, 4000));
}

TEST(MeshState, ATileCutAlongTheEdgesOfAMeshIsJagged) {
    EXPECT_FALSE(state_of(octant(10)).is_jagged());
    EXPECT_FALSE(state_of(cylinder(2, 1, 1.5, 20, 6)).is_jagged());
    EXPECT_FALSE(state_of(rectangle(1, 1, 1, 1)).is_jagged());
    // A grid of a sphere without every second cell along two of its sides, so that every vertex there is a corner.
    const TriangleMesh whole = sphere_grid(0.5, 12, 12);
    std::vector<int> kept;
    for (int cell = 0; cell < 144; ++cell)
        if (cell % 2 == 0 || (cell / 12 != 0 && cell / 12 != 11)) kept.insert(kept.end(), {2 * cell, 2 * cell + 1});
    std::vector<int> number(static_cast<std::size_t>(whole.vertex_count()), -1), vertices;
    TriangleMesh cut;
    cut.triangles.resize(static_cast<Eigen::Index>(kept.size()), 3);
    for (std::size_t t = 0; t < kept.size(); ++t)
        for (int k = 0; k < 3; ++k) {
            int& v = number[static_cast<std::size_t>(whole.triangles(kept[t], k))];
            if (v < 0) {
                v = static_cast<int>(vertices.size());
                vertices.push_back(whole.triangles(kept[t], k));
            }
            cut.triangles(static_cast<Eigen::Index>(t), k) = v;
        }
    cut.positions = whole.positions(vertices, Eigen::all);
    EXPECT_TRUE(state_of(cut).is_jagged());
}

TEST(MeshState, CreasesAreNoTurns) {
    const TriangleMesh roof =
        grid(10, 6, [](double u, double v) { return Vec3(2 * u - 1, 2 * v, -std::abs(2 * u - 1)); });
    const MeshState state = state_of(roof);
    EXPECT_NEAR(state.interior_turn, 0, 1e-9);
    EXPECT_EQ(find_creases(roof, Adjacency(roof.triangles, roof.vertex_count())).size(), 6u);
}

}  // namespace mesh_state_test
}  // namespace ripstop
