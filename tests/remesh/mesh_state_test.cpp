#include "ripstop/remesh/mesh_state.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/poor_meshes.h"
#include "support/shapes.h"

namespace ripstop {
namespace {

using namespace testing;
using ::testing::HasSubstr;

MeshState state_of(const TriangleMesh& mesh) {
    return measure_mesh(make_tile("tile", mesh, {.warp = Vec3(0.1, 0.2, 1)}));
}

TEST(MeshState, KnowsTheTurnsAndTheCurvatureOfACylinder) {
    const MeshState state = state_of(cylinder(2, 1, 1.5, 20, 6));
    EXPECT_NEAR(state.boundary_turn, 1.0 / 20, 1e-9);
    EXPECT_NEAR(state.turn_max, 1.0 / 20, 1e-9);
    EXPECT_NEAR(state.curvature, 0.5 * 19 / 20, 1e-3);  // 19 of its 20 strips' edges turn
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
    // Two curvatures of 1: the turns of a sphere's triangles add up to about 2 over its area.
    EXPECT_NEAR(needed_edge(state_of(octant(48))), 5 * degree / 2, 0.2 * 5 * degree / 2);
    const MeshState crumpled = state_of(lune(std::numbers::pi, 4, 4));
    EXPECT_GE(needed_edge(crumpled), edge_of(crumpled.area, 4000));
}

TEST(MeshState, CreasesAreNoTurns) {
    const TriangleMesh roof =
        grid(10, 6, [](double u, double v) { return Vec3(2 * u - 1, 2 * v, -std::abs(2 * u - 1)); });
    const MeshState state = state_of(roof);
    EXPECT_NEAR(state.interior_turn, 0, 1e-9);
    EXPECT_EQ(find_creases(roof, Adjacency(roof.triangles, roof.vertex_count())).size(), 6u);
}

}  // namespace
}  // namespace ripstop
