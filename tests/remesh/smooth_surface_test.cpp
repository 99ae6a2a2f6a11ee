#include "ripstop/remesh/smooth_surface.h"

#include <gtest/gtest.h>

#include <cmath>

#include "ripstop/assembly/seams/chain_curve.h"
#include "ripstop/mesh/disk.h"
#include "ripstop/model/tile/tile.h"
#include "ripstop/remesh/corner_normals.h"
#include "ripstop/tile/make_tile.h"
#include "support/poor_meshes.h"
#include "support/shapes.h"

namespace ripstop {
namespace smooth_surface_test {

using namespace testing;

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

/// The largest distance of the surface from the unit sphere, at the midpoints of triangles and edges.
double off_the_sphere(const TriangleMesh& mesh) {
    const Tile tile = make_tile("tile", mesh, {.warp = Vec3(0.1, 0.2, 1)});
    const SmoothSurface surface(mesh, Adjacency(mesh.triangles, mesh.vertex_count()), tile.boundary, {},
                                slopes_of(tile));
    double worst = 0;
    for (int t = 0; t < mesh.triangle_count(); ++t)
        for (const Vec3& weights : {Vec3(1, 1, 1), Vec3(1, 1, 0), Vec3(0, 1, 1), Vec3(1, 0, 1)})
            worst = std::max(worst, std::abs(surface.at({t, weights / weights.sum()}).norm() - 1));
    return worst;
}

TEST(SmoothSurface, IsTrueToTheFourthOrder) {
    const double coarse = off_the_sphere(octant(16)), fine = off_the_sphere(octant(32));
    EXPECT_LT(coarse, 1e-4);  // the triangles themselves are 3e-3 off
    EXPECT_GT(std::log2(coarse / fine), 3.8);
}

TEST(SmoothSurface, OfNeedlesIsTrueToo) {
    // The triangles themselves are 1e-3 off.
    EXPECT_LT(off_the_sphere(sphere_grid(0.3, 60, 6)), 5e-5);
    EXPECT_LT(off_the_sphere(random_diagonals(0.3, 10, 10, 7)), 5e-5);
}

TEST(SmoothSurface, OfAPlaneIsThePlane) {
    const TriangleMesh mesh = rectangle(2, 1, 5, 3);
    const Tile tile = make_tile("tile", mesh, {});
    const SmoothSurface surface(mesh, Adjacency(mesh.triangles, mesh.vertex_count()), tile.boundary, {},
                                slopes_of(tile));
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        const Vec3 at = surface.at({t, Vec3(0.2, 0.3, 0.5)});
        const Vec3 flat = 0.2 * mesh.corner(t, 0) + 0.3 * mesh.corner(t, 1) + 0.5 * mesh.corner(t, 2);
        EXPECT_LT((at - flat).norm(), 1e-12);
    }
}

TEST(CornerNormals, DifferFromOneSideOfACreaseToTheOther) {
    const TriangleMesh roof =
        grid(8, 6, [](double u, double v) { return Vec3(2 * u - 1, 2 * v, -std::abs(2 * u - 1)); });
    const Adjacency adjacency(roof.triangles, roof.vertex_count());
    std::vector<std::array<int, 2>> ridge;
    for (const int h : adjacency.edges())
        if (roof.positions(adjacency.from(h), 0) == 0 && roof.positions(adjacency.to(h), 0) == 0)
            ridge.push_back({adjacency.from(h), adjacency.to(h)});
    const Points3 normals = corner_normals(roof, adjacency, ridge);
    for (int t = 0; t < roof.triangle_count(); ++t)
        for (int k = 0; k < 3; ++k) {
            const double side = (roof.corner(t, 0) + roof.corner(t, 1) + roof.corner(t, 2)).x() > 0 ? 1 : -1;
            EXPECT_LT((Vec3(normals.row(3 * t + k)) - Vec3(side, 0, 1) / std::sqrt(2.0)).norm(), 1e-9);
        }
}

}  // namespace smooth_surface_test
}  // namespace ripstop
