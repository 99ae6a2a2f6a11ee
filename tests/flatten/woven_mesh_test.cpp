#include "ripstop/flatten/weave/woven_mesh.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "ripstop/base/error.h"
#include "ripstop/flatten/tools/laying.h"
#include "ripstop/geometry/triangle.h"
#include "ripstop/mesh/boundary.h"
#include "ripstop/mesh/change/flips.h"
#include "ripstop/tile/make_tile.h"
#include "support/shapes.h"

namespace ripstop {
namespace woven_mesh_test {

Points2 positions_of(const Tile& tile, const WovenOptions& options = {}) {
    const Flattening flat = flatten_woven(tile, Fabric{}, options);
    EXPECT_TRUE(flat.summary.usable()) << flat.summary.text();
    EXPECT_EQ(flat.positions.rows(), tile.mesh.vertex_count());
    EXPECT_TRUE(flat.positions.allFinite());
    return flat.positions;
}

/// The largest relative length change of an edge.
double worst_edge(const Tile& tile, const Points2& flat) {
    const Adjacency adjacency(tile.mesh.triangles, tile.mesh.vertex_count());
    double worst = 0;
    for (const int h : adjacency.edges()) {
        const double length =
            (tile.mesh.positions.row(adjacency.from(h)) - tile.mesh.positions.row(adjacency.to(h))).norm();
        const double laid = (flat.row(adjacency.from(h)) - flat.row(adjacency.to(h))).norm();
        worst = std::max(worst, std::abs(laid / length - 1));
    }
    return worst;
}

double area_error(const Tile& tile, const Points2& flat) {
    double sum = 0;
    for (int t = 0; t < tile.mesh.triangle_count(); ++t) {
        const auto corners = tile.mesh.triangles.row(t);
        sum += signed_area(flat.row(corners[0]), flat.row(corners[1]), flat.row(corners[2]));
    }
    return sum / surface_area(tile.mesh) - 1;
}

double boundary_error(const Tile& tile, const Points2& flat) {
    const std::vector<int> loop = closed(tile.boundary);
    return edge_lengths(flat, loop).sum() / edge_lengths(tile.mesh.positions, loop).sum() - 1;
}

/// The plane square with a slit from one side to its middle, whose two sides are not welded; then bent by
/// `height`.
template <class Height>
TriangleMesh slit_square(int n, Height&& height) {
    TriangleMesh mesh = testing::rectangle(2, 2, n, n);
    const int before = mesh.vertex_count();
    const int first = n / 2 * (n + 1);
    mesh.positions.conservativeResize(before + n / 2, 3);
    for (int i = 0; i < n / 2; ++i) mesh.positions.row(before + i) = mesh.positions.row(first + i);
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        const bool above = mesh.corner(t, 0).y() + mesh.corner(t, 1).y() + mesh.corner(t, 2).y() > 3;
        for (int k = 0; k < 3 && above; ++k)
            if (int& v = mesh.triangles(t, k); v >= first && v < first + n / 2) v += before - first;
    }
    for (int v = 0; v < mesh.vertex_count(); ++v)
        mesh.positions(v, 2) = height(mesh.positions(v, 0) - 1, mesh.positions(v, 1) - 1);
    return mesh;
}

TriangleMesh one_triangle(double height) {
    TriangleMesh mesh;
    mesh.positions.resize(3, 3);
    mesh.positions << 0, 0, 0, 1, 0, 0, 0.3, height, 0.1 * height;
    mesh.triangles.resize(1, 3);
    mesh.triangles << 0, 1, 2;
    return mesh;
}

TEST(FlattenWoven, LaysAPlaneWithItsWarpAlongXAndItsWeftAlongY) {
    TileOptions options;
    options.warp = Vec3(1, 2, 0);
    const Tile tile = make_tile("plane", testing::rectangle(2, 1, 12, 6), options);
    const Points2 flat = positions_of(tile);
    const Vec2 warp = Vec2(1, 2).normalized();
    for (int v = 0; v < tile.mesh.vertex_count(); ++v) {
        const Vec2 p = Vec2(tile.mesh.positions.row(v).leftCols(2)) - Vec2(1, 0.5);
        EXPECT_NEAR(flat(v, 0), p.dot(warp), 1e-11);
        EXPECT_NEAR(flat(v, 1), cross(warp, p), 1e-11);
    }
}

// Yarns are straight lines on the surface, so on a developable the weave closes without strain, up to rounding.
// The mesh of the tangent surface itself has angle defects of up to 2e-10 rad, which add up over its length. (The
// published fit of a cone left 0.25 % of area and 0.05 % of boundary.)
TEST(FlattenWoven, IsExactOnDevelopables) {
    for (const double turn : {0.0, 0.5})
        for (const auto& shape : testing::developable_shapes()) {
            SCOPED_TRACE(shape.name);
            TileOptions options;
            options.grain_turn = turn;
            const Tile tile = make_tile(shape.name, shape.mesh, options);
            EXPECT_LT(worst_edge(tile, positions_of(tile)), 1e-8);
        }
}

TEST(FlattenWoven, BeatsThePublishedConeOnAMeshThatIsDevelopableOnlyInTheLimit) {
    const Tile tile = make_tile("cone", testing::staggered_cone(0.5, 2, 1, 2.5, 16, 12));
    const Points2 flat = positions_of(tile);
    EXPECT_LT(std::abs(area_error(tile, flat)), 0.0025);
    EXPECT_LT(std::abs(boundary_error(tile, flat)), 0.0005);
}

TEST(FlattenWoven, IsExactOnTilesThatAreNotConvex) {
    const auto flat_height = [](double, double) { return 0.0; };
    const auto ring = testing::grid(
        80, 6, [](double u, double v) { return Vec3((2 - v) * std::cos(6.1 * u), (2 - v) * std::sin(6.1 * u), 0); });
    const auto whole_cone = testing::cone(0.5, 2 * std::numbers::pi, 0.3, 2, 40, 12);
    for (const TriangleMesh& mesh : {slit_square(20, flat_height), ring, whole_cone}) {
        const Tile tile = make_tile("tile", mesh);
        EXPECT_LT(worst_edge(tile, positions_of(tile)), 1e-9);
    }
}

TEST(FlattenWoven, IsExactOverSharpFolds) {
    const auto pleats = testing::grid(40, 20, [](double u, double v) {
        const auto i = static_cast<int>(std::lround(40 * u));
        return Vec3(0.004 * i, v, i % 2 * 0.2);
    });
    const Tile tile = make_tile("pleats", pleats);
    EXPECT_LT(worst_edge(tile, positions_of(tile)), 1e-9);
}

// Published for one mesh and one centre, by a descent stopped at 1 %: boundary 6.37 %, area 2.38 % with springs
// 1:1:1, and 5.70 %, 2.39 % with 500:500:1. The free optimum of an isotropic sheet is 5.09 %, 0.16 %. The ranges
// include both. [WTY05] print 6.37 % and 2.38 % for springs 1:1:1 on an octant, with an unknown mesh and grain;
// ours gives 5.2 to 7.0 % and 1.4 to 2.4 % over various meshes.
TEST(FlattenWoven, GivesAnOctantThePublishedErrorsWithSpringsAllAlike) {
    const Tile tile = make_tile("octant", testing::octant(24));
    const Points2 flat = positions_of(tile, {.warp_stiffness = 1, .weft_stiffness = 1});
    EXPECT_NEAR(boundary_error(tile, flat), 0.0637, 0.006);
    EXPECT_NEAR(area_error(tile, flat), 0.0238, 0.01);
}

TEST(FlattenWoven, GivesAnOctantErrorsOfThePublishedOrder) {
    for (const int n : {12, 24})
        for (const double yarns : {1.0, 500.0}) {
            const Tile tile = make_tile("octant", testing::octant(n));
            const Points2 flat = positions_of(tile, {.warp_stiffness = yarns, .weft_stiffness = yarns});
            EXPECT_GT(boundary_error(tile, flat), 0.04);
            EXPECT_LT(boundary_error(tile, flat), 0.07);
            EXPECT_GT(area_error(tile, flat), 0.0);
            EXPECT_LT(area_error(tile, flat), 0.03);
            EXPECT_EQ(count_flipped(tile.mesh.triangles, flat), 0);
        }
}

// Kubicek and Zemcik report 14.01 % and 1.93 % for a quarter of a sphere; they start from this fit.
TEST(FlattenWoven, GivesAQuarterSphereThePapersErrors) {
    const Tile tile = make_tile("quarter", testing::lune(std::numbers::pi / 2, 16, 32));
    const Points2 flat = positions_of(tile);
    EXPECT_NEAR(boundary_error(tile, flat), 0.1401, 0.005);
    EXPECT_NEAR(area_error(tile, flat), 0.0193, 0.005);
}

TEST(FlattenWoven, FlipsNothing) {
    for (const auto& shapes : {testing::developable_shapes(), testing::curved_shapes()})
        for (const auto& shape : shapes) {
            const Tile tile = make_tile(shape.name, shape.mesh);
            const Flattening flat = flatten_woven(tile, Fabric{});
            EXPECT_EQ(count_flipped(tile.mesh.triangles, flat.positions), 0) << shape.name;
            EXPECT_EQ(flat.summary.reason.find("flipped"), std::string::npos)
                << shape.name << ": " << flat.summary.text();
        }
}

TEST(FlattenWoven, DoesNotCareWhereTheTileIs) {
    const auto turned = [](const Vec3& v) {
        TriangleMesh mesh;
        mesh.positions = (Points3(2, 3) << 0, 0, 0, v.x(), v.y(), v.z()).finished();
        mesh.triangles.resize(0, 3);
        mesh = testing::moved(mesh);
        return Vec3(mesh.positions.row(1) - mesh.positions.row(0));
    };
    for (const auto& shape : testing::curved_shapes()) {
        TileOptions here;
        here.warp = longest_axis(shape.mesh);
        TileOptions there;
        there.warp = turned(*here.warp);
        const Points2 a = positions_of(make_tile(shape.name, shape.mesh, here));
        const Points2 b = positions_of(make_tile(shape.name, testing::moved(shape.mesh), there));
        EXPECT_LT((a - b).cwiseAbs().maxCoeff(), 1e-9) << shape.name;
    }
}

TEST(FlattenWoven, ScalesWithTheTile) {
    for (const auto& shape : testing::curved_shapes()) {
        TileOptions options;
        options.warp = longest_axis(shape.mesh);
        const Points2 a = positions_of(make_tile(shape.name, shape.mesh, options));
        const Points2 b = positions_of(make_tile(shape.name, testing::scaled(shape.mesh, 1000), options));
        EXPECT_LT((a - b / 1000).cwiseAbs().maxCoeff(), 1e-9) << shape.name;
    }
}

// The crossings settle in an order that is not mirrored, and stop when a sweep changes the energy by less than 1
// %.
TEST(FlattenWoven, MirrorsAMirroredTileWithinTheFit) {
    for (const auto& shape : testing::curved_shapes()) {
        TileOptions here;
        here.warp = longest_axis(shape.mesh);
        TileOptions there;
        there.warp = here.warp->cwiseProduct(Vec3(-1, 1, 1));
        const Points2 a = positions_of(make_tile(shape.name, shape.mesh, here));
        Points2 b = positions_of(make_tile(shape.name, testing::mirrored(shape.mesh), there));
        b.col(1) *= -1;
        EXPECT_LT((a - b).rowwise().norm().maxCoeff(), 1e-3 * bounding_diagonal(shape.mesh)) << shape.name;
    }
}

TEST(FlattenWoven, GivesTheSameBytesOnEveryRun) {
    const Tile tile = make_tile("saddle", testing::saddle(1, 0.4, 12));
    EXPECT_EQ(positions_of(tile), positions_of(tile));
}

TEST(FlattenWoven, IsExactOnTilesOfOneAndTwoTrianglesAndOnNeedles) {
    TriangleMesh folded;
    folded.positions = (Points3(4, 3) << 0, 0, 0, 1, 0, 0, 0.3, 0.8, 0.2, 0.1, 0.1, 0.1).finished();
    folded.triangles = (Triangles(2, 3) << 0, 1, 2, 1, 3, 2).finished();
    const auto strip =
        testing::grid(40, 1, [](double u, double v) { return Vec3(std::cos(6 * u), std::sin(6 * u), 1e-3 * v); });
    for (const TriangleMesh& mesh : {one_triangle(0.8), one_triangle(1e-5), folded, strip}) {
        const Tile tile = make_tile("tile", mesh);
        EXPECT_LT(worst_edge(tile, positions_of(tile)), 1e-9);
    }
}

TEST(FlattenWoven, GivesEveryVertexAPlaceHoweverHardTheTile) {
    const auto hard = {
        slit_square(20, [](double x, double y) { return 0.3 * (x * x + y * y); }),
        slit_square(20, [](double x, double y) { return 0.4 * (x * x - y * y); }),
        testing::cap(2.6, 12),
        testing::saddle(3, 0.8, 16),
        testing::torus_patch(3, 1, 3, 0.2, 5.5, 24, 24),
        testing::grid(16, 16, [](double u, double v) { return Vec3(u, v, 0.1 * std::sin(15 * u) * std::cos(14 * v)); }),
        testing::grid(60, 3, [](double u, double v) {  // a ramp that winds over itself
            return Vec3((2 - v) * std::cos(14 * u), (2 - v) * std::sin(14 * u), 1.4 * u);
        })};
    for (const TriangleMesh& mesh : hard) {
        const Tile tile = make_tile("hard", mesh);
        const Flattening flat = flatten_woven(tile, Fabric{});
        ASSERT_TRUE(flat.summary.usable()) << flat.summary.text();
        EXPECT_TRUE(flat.positions.allFinite());
        const int flipped = count_flipped(mesh.triangles, flat.positions);
        if (flipped > 0) {
            EXPECT_NE(flat.summary.reason.find(std::to_string(flipped) + " remain"), std::string::npos)
                << flat.summary.text();
        }
    }
}

TEST(FlattenWoven, KeepsToStretchedMeshes) {
    const auto stretched =
        testing::grid(6, 60, [](double u, double v) { return Vec3(0.6 * (u - 0.5), 0.6 * (v - 0.5), 1).normalized(); });
    const Tile tile = make_tile("10:1", stretched);
    const Points2 flat = positions_of(tile);
    EXPECT_EQ(count_flipped(stretched.triangles, flat), 0);
    // The same patch with square cells: boundary 0.23 %, area 0.04 %.
    EXPECT_NEAR(boundary_error(tile, flat), 0.0023, 0.001);
    EXPECT_NEAR(area_error(tile, flat), 0.0004, 0.001);
}

TEST(FlattenWoven, RefusesOptionsOutOfRange) {
    const Tile tile = make_tile("plane", testing::rectangle(1, 1, 2, 2));
    EXPECT_THROW(flatten_woven(tile, Fabric{}, {.spacing = 0}), InputError);
    EXPECT_THROW(flatten_woven(tile, Fabric{}, {.weft_stiffness = -1}), InputError);
    EXPECT_THROW(flatten_woven(tile, Fabric{}, {.energy_tolerance = std::nan("")}), InputError);
    EXPECT_THROW(flatten_woven(tile, Fabric{}, {.max_iterations = -1}), InputError);
}

}  // namespace woven_mesh_test
}  // namespace ripstop
