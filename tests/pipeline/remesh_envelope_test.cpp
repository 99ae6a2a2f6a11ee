#include "ripstop/pipeline/remesh/remesh_envelope.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "ripstop/assembly/seams/find_seams.h"
#include "ripstop/base/error.h"
#include "ripstop/design/natural/gores.h"
#include "ripstop/flatten/method.h"
#include "ripstop/geometry/polygon.h"
#include "ripstop/io/mesh/mesh_file.h"
#include "ripstop/measure/equal_tiles.h"
#include "ripstop/measure/measure_accuracy.h"
#include "ripstop/mesh/disk.h"
#include "ripstop/pipeline/read/read_envelope.h"
#include "ripstop/remesh/mesh_state.h"
#include "ripstop/remesh/remesh_disk.h"
#include "ripstop/tile/make_tile.h"
#include "ripstop/tile/targets.h"
#include "support/envelopes.h"
#include "support/poor_meshes.h"
#include "support/remeshing.h"
#include "support/shapes.h"
#include "support/shared_data.h"

namespace ripstop {
namespace remesh_envelope_test {

using namespace testing;
using ::testing::HasSubstr;
constexpr double half = 0.35;  // of the sphere patch [rad]

using Remeshing = RemeshingTest;

Envelope one_tile(const TriangleMesh& mesh, const Vec3& warp = Vec3::UnitZ()) {
    Envelope envelope{{make_tile("tile", mesh, {.warp = warp})}};
    add_seams(envelope);
    return envelope;
}

Tile remeshed(const TriangleMesh& mesh, const RemeshOptions& options, const Vec3& warp = Vec3::UnitZ()) {
    Envelope envelope = one_tile(mesh, warp);
    const std::vector<std::string> remarks = remesh_envelope(envelope, options);
    EXPECT_TRUE(envelope.tiles[0].remeshed) << ::testing::PrintToString(remarks);
    return envelope.tiles[0];
}

/// The first vertices of the chains.
Points3 corners_of(const Tile& tile) {
    Points3 corners(static_cast<Eigen::Index>(tile.chains.size()), 3);
    for (std::size_t c = 0; c < tile.chains.size(); ++c)
        corners.row(static_cast<Eigen::Index>(c)) = tile.mesh.positions.row(tile.chains[c].vertices.front());
    return corners;
}

/// The distance of a tile's flat outline from another's after aligning their corners, relative to the tile's size.
double outline_difference(const Tile& tile, const Tile& good) {
    const auto flat = [](const Tile& t) { return method_named("seam-exact").flatten(t, Fabric{}).positions; };
    const Points2 mine = flat(tile), theirs = flat(good);
    Eigen::MatrixXd p(2, tile.chains.size()), q(2, tile.chains.size());
    for (std::size_t c = 0; c < tile.chains.size(); ++c) {
        p.col(static_cast<Eigen::Index>(c)) = mine.row(tile.chains[c].vertices.front()).transpose();
        q.col(static_cast<Eigen::Index>(c)) = theirs.row(good.chains[c].vertices.front()).transpose();
    }
    const Eigen::MatrixXd move = Eigen::umeyama(p, q, false);
    Points2 outline(static_cast<Eigen::Index>(good.boundary.size()), 2);
    for (std::size_t i = 0; i < good.boundary.size(); ++i)
        outline.row(static_cast<Eigen::Index>(i)) = theirs.row(good.boundary[i]);
    double worst = 0;
    for (const int v : tile.boundary) {
        const Vec2 laid = move.topLeftCorner<2, 2>() * Vec2(mine.row(v)) + move.topRightCorner<2, 1>();
        worst = std::max(worst, distance_to_outline(outline, laid));
    }
    return worst / bounding_diagonal(good.mesh);
}

/// Properties of every remeshed tile.
void expect_sound(const Tile& before, const Tile& after, double least_degrees) {
    EXPECT_NO_THROW(require_disk(after.mesh, Adjacency(after.mesh.triangles, after.mesh.vertex_count()), "tile"));
    EXPECT_EQ(locked_edges(after.mesh), 0);
    EXPECT_GT(least_angle(after.mesh) / degree, least_degrees);
    ASSERT_EQ(after.chains.size(), before.chains.size());
    EXPECT_EQ(corners_of(after), corners_of(before));
    EXPECT_EQ(after.grain.direction, before.grain.direction);
    EXPECT_EQ(after.grain.source, before.grain.source);
    // Both triangles lie on one smooth surface, the old one below the middle of the new one, so there is no fold.
    for (int t = 0; t < after.mesh.triangle_count(); ++t) {
        const Vec3 middle = (after.mesh.corner(t, 0) + after.mesh.corner(t, 1) + after.mesh.corner(t, 2)) / 3;
        const Vec3 normal = (after.mesh.corner(t, 1) - after.mesh.corner(t, 0))
                                .cross(after.mesh.corner(t, 2) - after.mesh.corner(t, 0));
        ASSERT_GT(normal.dot(middle), 0) << "triangle " << t << " of a sphere looks inward";
    }
}

// An inscribed mesh of 40 x 40 cells lacks 1e-4 of the sphere's area, which is about the accuracy of its shape.
Tile good_tile() {
    return one_tile(sphere_grid(half, 40, 40)).tiles[0];
}

TEST_F(Remeshing, OfSliversLandsOnTheGoodMeshesShape) {
    const TriangleMesh slivers = sphere_grid(half, 300, 12);
    Envelope envelope = one_tile(slivers);
    const Tile before = envelope.tiles[0];
    const std::vector<std::string> remarks = remesh_envelope(envelope, automatic);
    ASSERT_TRUE(envelope.tiles[0].remeshed);
    EXPECT_THAT(remarks, ::testing::ElementsAre(HasSubstr("slivers")));
    expect_sound(before, envelope.tiles[0], 15);
    EXPECT_LT(outline_difference(envelope.tiles[0], good_tile()), 1e-4);
}

TEST_F(Remeshing, OfRandomDiagonalsLandsOnTheGoodMeshesShape) {
    const TriangleMesh mesh = random_diagonals(half, 24, 24, 5);
    const Tile tile = remeshed(mesh, by_length(0.03));
    expect_sound(one_tile(mesh).tiles[0], tile, 15);
    EXPECT_LT(outline_difference(tile, good_tile()), 1e-4);
}

TEST_F(Remeshing, OfJumbledVerticesLandsOnTheGoodMeshesShape) {
    const TriangleMesh mesh = jumbled(half, 24, 24, 0.3, 5);
    const Tile tile = remeshed(mesh, by_length(0.03));
    expect_sound(one_tile(mesh).tiles[0], tile, 15);
    EXPECT_LT(outline_difference(tile, good_tile()), 1e-4);
}

TEST_F(Remeshing, OfADenseBoundaryThinsItAlongTheCurve) {
    const TriangleMesh mesh = with_dense_boundary(half, 20, 20, 9);
    const Tile before = one_tile(mesh).tiles[0], tile = remeshed(mesh, by_length(0.035));
    EXPECT_LT(tile.boundary.size(), before.boundary.size() / 4);
    expect_sound(before, tile, 15);
    EXPECT_LT(outline_difference(tile, good_tile()), 1e-4);
}

TEST_F(Remeshing, OfTooFineAMeshKeepsItsShape) {
    const TriangleMesh mesh = sphere_grid(half, 168, 168);
    Envelope envelope = one_tile(mesh);
    const Tile before = envelope.tiles[0];
    remesh_envelope(envelope, automatic);
    ASSERT_TRUE(envelope.tiles[0].remeshed);
    EXPECT_EQ(envelope.tiles[0].remeshed->triangles_before, 2 * 168 * 168);
    EXPECT_LT(envelope.tiles[0].mesh.triangle_count(), 4000);
    expect_sound(before, envelope.tiles[0], 15);
    EXPECT_LT(outline_difference(envelope.tiles[0], before), 1e-4);
}

TEST_F(Remeshing, OfACoarseOctantComesNearerToTheSphere) {
    const TriangleMesh coarse = octant(10);  // 100 triangles, 9 degrees per edge
    const Tile before = one_tile(coarse).tiles[0], tile = remeshed(coarse, automatic);
    const Tile fine = one_tile(octant(64)).tiles[0];
    expect_sound(before, tile, 15);
    const double area = std::numbers::pi / 2, edge = std::numbers::pi / 2;
    const double area_before = surface_area(before.mesh) / area - 1, area_after = surface_area(tile.mesh) / area - 1;
    EXPECT_LT(std::abs(area_after), 0.1 * std::abs(area_before));
    EXPECT_LT(std::abs(area_after), 1e-3);
    // The error of the chains is of sixth order in their turn: (9 degrees)^6 is 1.5e-5, divided by some thousand.
    EXPECT_NEAR(drawn_lengths(tile).sum(), 3 * edge, 3 * edge * 1e-6);
    EXPECT_LT(outline_difference(tile, fine), 0.1 * outline_difference(before, fine));
    // The middles of the old triangles lie 6e-3 inside the sphere. A tenth of that remains near the corners, where
    // normals are least accurate.
    const Eigen::VectorXd off = tile.mesh.positions.rowwise().norm().array() - 1;
    EXPECT_LT(off.cwiseAbs().maxCoeff(), 6e-4);
    EXPECT_LT(off.cwiseAbs().mean(), 1e-4);
}

TEST_F(Remeshing, OfACoarseTorusComesNearerToTheFineOne) {
    const TriangleMesh coarse = torus_patch(3, 1, 0.5, 2.6, 3.7, 7, 7);
    const Tile before = one_tile(coarse).tiles[0], tile = remeshed(coarse, automatic);
    const Tile fine = one_tile(torus_patch(3, 1, 0.5, 2.6, 3.7, 64, 64)).tiles[0];
    EXPECT_LT(std::abs(surface_area(tile.mesh) - surface_area(fine.mesh)),
              0.2 * std::abs(surface_area(before.mesh) - surface_area(fine.mesh)));
    EXPECT_LT(outline_difference(tile, fine), 0.3 * outline_difference(before, fine));
}

/// The largest strain of a flattened tile, and the error of its flat area.
struct Laid {
    double strain = 0, area_error = 0;
};
Laid laid_flat(const Tile& tile, double area) {
    const Flattening flat = method_named("seam-exact").flatten(tile, Fabric{});
    const Accuracy a = measure_accuracy(tile, flat.positions, Fabric{}, flat.edges_on_curve);
    EXPECT_TRUE(flat.summary.usable());
    EXPECT_EQ(a.flipped + a.overlaps, 0);
    return {std::max({-a.warp_strain_min, a.warp_strain_max, -a.weft_strain_min, a.weft_strain_max}),
            a.flat_area / area - 1};
}

TriangleMesh strap(int along, int across, double width, double slant) {
    constexpr double pi = std::numbers::pi;
    return grid(along, across, [=](double u, double v) {
        return Vec3(0.1 * std::cos(pi * u), slant * u + width * v, 0.1 * std::sin(pi * u));
    });
}

// A strap around half a cylinder of 100 mm radius. Its facets lack t^2 / 24 of its area: 0.6 % with 8 quads.
TEST_F(Remeshing, OfAStrapStaysOnTheCylinderAndDevelopable) {
    for (const int quads : {7, 10, 16, 20})
        for (const double width : {0.02, 0.05, 0.1})
            for (const double slant : {0.0, 0.1})
                for (const int across : {1, quads == 10 ? 3 : 1}) {
                    const double area = 0.1 * std::numbers::pi * width;
                    const Tile tile = remeshed(strap(quads, across, width, slant), automatic, Vec3::UnitY());
                    const Laid laid = laid_flat(tile, area);
                    EXPECT_LT(laid.strain, 5e-4) << quads << " quads, " << width << ", " << slant;
                    EXPECT_NEAR(laid.area_error, 0, 1e-3) << quads << " quads, " << width << ", " << slant;
                    EXPECT_NEAR(surface_area(tile.mesh) / area, 1, 1e-3);
                    EXPECT_EQ(locked_edges(tile.mesh), 0);
                }
}

TEST_F(Remeshing, OfConesAndTangentDevelopablesAddsNoStrain) {
    constexpr double pi = std::numbers::pi;
    const double c = std::hypot(0.5, 0.4);
    const double tangents = 0.5 / (c * c) * c * 1.6 * (0.8 * 0.8 - 0.1 * 0.1) / 2;  // curvature x length x v dv
    const struct {
        TriangleMesh mesh;
        double area;
    } shapes[] = {{cone(0.4, pi, 0.2, 1, 8, 1), 0.5 * 0.96 * pi * std::sin(0.4)},
                  {cone(0.4, pi, 0.2, 1, 12, 3), 0.5 * 0.96 * pi * std::sin(0.4)},
                  {tangent_developable(0.5, 0.4, 1.6, 0.1, 0.8, 8, 4), tangents},
                  {cylinder(0.1, 1.999 * pi, 0.05, 24, 1), 0.1 * 1.999 * pi * 0.05}};
    for (const auto& [mesh, area] : shapes) {
        const Laid laid = laid_flat(remeshed(mesh, automatic), area);
        EXPECT_LT(laid.strain, 1e-3) << area;
        EXPECT_NEAR(laid.area_error, 0, 1e-3) << area;
    }
}

TEST_F(Remeshing, KeepsACreaseSharp) {
    // A roof: two planes that meet at 60 degrees along x = 0.
    const TriangleMesh roof = grid(10, 6, [](double u, double v) {
        const double x = 2 * u - 1;
        return Vec3(x, 2 * v, -std::abs(x) * std::tan(30 * degree));
    });
    Envelope envelope{{make_tile("roof", roof, {.warp = Vec3::UnitY()})}};
    add_seams(envelope);
    remesh_envelope(envelope, by_length(0.15));
    const TriangleMesh& mesh = envelope.tiles[0].mesh;
    ASSERT_TRUE(envelope.tiles[0].remeshed);
    double ridge = 0;
    const Adjacency adjacency(mesh.triangles, mesh.vertex_count());
    for (const int h : adjacency.edges())
        if (std::abs(mesh.positions(adjacency.from(h), 0)) < 1e-12 &&
            std::abs(mesh.positions(adjacency.to(h), 0)) < 1e-12)
            ridge += (mesh.positions.row(adjacency.to(h)) - mesh.positions.row(adjacency.from(h))).norm();
    EXPECT_NEAR(ridge, 2, 1e-12);
    EXPECT_NEAR(surface_area(mesh), surface_area(roof), 1e-9);
}

TEST_F(Remeshing, KeepsTheVertexWhereAnEdgeGoesOverACrease) {
    // The ridge of a roof meets its eaves at 0.37 of their length, where no even division has a vertex.
    const TriangleMesh roof = grid(10, 6, [](double u, double v) {
        const double x = u <= 0.5 ? 0.74 * u : 0.37 + 1.26 * (u - 0.5);
        return Vec3(x, v, 0.37 - std::abs(x - 0.37));
    });
    Envelope envelope{{make_tile("roof", roof, {.warp = Vec3::UnitY()})}};
    add_seams(envelope);
    remesh_envelope(envelope, by_length(0.13));
    ASSERT_TRUE(envelope.tiles[0].remeshed);
    EXPECT_NEAR(surface_area(envelope.tiles[0].mesh), surface_area(roof), 1e-9);
}

TEST_F(Remeshing, CarriesTheWarpOfEachTriangle) {
    const TriangleMesh mesh = sphere_grid(half, 12, 12);
    Points3 field(mesh.triangle_count(), 3);
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        const Vec3 middle = (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3;
        field.row(t) = Vec3(0, middle.y(), 1).normalized();
    }
    Envelope envelope{{make_tile("tile", mesh, {.warp_field = field})}};
    add_seams(envelope);
    remesh_envelope(envelope, by_length(0.03));
    const Tile& tile = envelope.tiles[0];
    ASSERT_TRUE(tile.remeshed);
    ASSERT_EQ(tile.grain.field.rows(), tile.mesh.triangle_count());
    for (int t = 0; t < tile.mesh.triangle_count(); ++t) {
        const Vec3 middle = (tile.mesh.corner(t, 0) + tile.mesh.corner(t, 1) + tile.mesh.corner(t, 2)) / 3;
        // The field changes as much as its argument, over the 0.06 m of an old triangle.
        EXPECT_LT((Vec3(tile.grain.field.row(t)) - Vec3(0, middle.y(), 1).normalized()).norm(), 0.06);
    }
}

TEST_F(Remeshing, IsNotAskedForTwice) {
    for (const TriangleMesh& mesh : {octant(10), lune(std::numbers::pi / 2, 6, 12), sphere_grid(half, 300, 12)}) {
        Envelope envelope = one_tile(mesh);
        EXPECT_EQ(remesh_envelope(envelope, automatic).size(), 1u);
        EXPECT_TRUE(remesh_envelope(envelope, automatic).empty());
    }
}

TEST_F(Remeshing, LeavesWhatIsFlat) {
    Envelope envelope = one_tile(grid(40, 1, [](double u, double v) { return Vec3(0, 4 * u, v); }));
    EXPECT_TRUE(remesh_envelope(envelope, automatic).empty());
}

TEST_F(Remeshing, OfEqualTilesKeepsThemEqual) {
    const TriangleMesh gore = lune(1, 6, 12);
    std::vector<NamedMesh> tiles = {{"first", moved(gore)}, {"second", gore}, {"mirror", mirrored(gore)}};
    for (Eigen::Index v = 0; v < tiles[2].mesh.positions.rows(); ++v) tiles[2].mesh.positions(v, 0) -= 5;
    for (Eigen::Index v = 0; v < tiles[0].mesh.positions.rows(); ++v) tiles[0].mesh.positions(v, 0) += 20;
    Envelope envelope = make_envelope(tiles, {});
    remesh_envelope(envelope, automatic);
    const std::vector<Likeness> likeness = find_equal_tiles(envelope.tiles);
    EXPECT_EQ(likeness[1].to, 0);
    EXPECT_EQ(likeness[2].to, 0);
    EXPECT_FALSE(likeness[1].vertex.empty());
    EXPECT_FALSE(likeness[2].vertex.empty());
}

int kinds_of(const std::vector<Tile>& tiles) {
    const std::vector<Likeness> likeness = find_equal_tiles(tiles);
    return static_cast<int>(
        std::count_if(likeness.begin(), likeness.end(), [](const Likeness& like) { return like.to < 0; }));
}

/// The coordinates as a file with so many decimals stores them.
std::vector<NamedMesh> rounded(std::vector<NamedMesh> meshes, int decimals) {
    const double step = std::pow(10, -decimals);
    for (NamedMesh& named : meshes) named.mesh.positions = (named.mesh.positions / step).array().round() * step;
    return meshes;
}

TEST_F(Remeshing, OfEqualTilesRoundedByTheirFileKeepsThemEqual) {
    std::vector<NamedMesh> gores, panels;
    for (int i = 0; i < 8; ++i) {  // mirror images too
        TriangleMesh gore = lune(1, 4, 8);
        if (i % 3 == 2) gore = mirrored(gore);
        const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.3 + i, Vec3(1, 2, i).normalized()).toRotationMatrix();
        gore.positions = (turn * gore.positions.transpose()).transpose();
        gore.positions.col(0).array() += 4.1 * i;
        gores.push_back({"gore " + std::to_string(i), gore});
    }
    EnvelopeDesign design;
    design.gores = 8;
    design.panels = 4;
    design.volume = 300;
    design.edge_length = 1;
    panels = design_natural(design);
    for (const int decimals : {6, 9, 12}) {
        Envelope envelope = make_envelope(rounded(gores, decimals), {});
        remesh_envelope(envelope, automatic);
        for (const Tile& tile : envelope.tiles) EXPECT_TRUE(tile.remeshed) << tile.name;
        EXPECT_EQ(kinds_of(envelope.tiles), 1) << decimals << " decimals";
        envelope = make_envelope(rounded(panels, decimals), {});
        EXPECT_EQ(kinds_of(envelope.tiles), 4);
        remesh_envelope(envelope, by_length(0.4));
        EXPECT_EQ(kinds_of(envelope.tiles), 4) << decimals << " decimals";
    }
}

Envelope read_by(const std::filesystem::path& file) {
    ReadOptions options;
    options.unit = LengthUnit{"m", 1};
    options.remesh = automatic;
    return read_input(file, options).envelope;
}

TEST_F(Remeshing, OfATentsEqualSegmentsKeepsThemEqual) {
    RIPSTOP_REQUIRE_SHARED(file, "faults/shapes/equal_segments.obj");
    const Envelope envelope = read_by(file);
    ASSERT_EQ(envelope.tiles.size(), 8u);
    for (const Tile& tile : envelope.tiles) EXPECT_TRUE(tile.remeshed) << tile.name;
    EXPECT_EQ(kinds_of(envelope.tiles), 1);
}

TEST_F(Remeshing, OfPublicStrapsAddsNeitherAreaNorStrain) {
    RIPSTOP_REQUIRE_SHARED(folder, "faults/shapes");
    const std::pair<const char*, double> straps[] = {{"strap_silent.obj", 0.02}, {"strap_refused.obj", 0.05}};
    for (const auto& [name, width] : straps) {
        const Envelope envelope = read_by(folder / name);
        ASSERT_TRUE(envelope.tiles[0].remeshed);
        const Laid laid = laid_flat(envelope.tiles[0], 0.1 * std::numbers::pi * width);
        EXPECT_LT(laid.strain, 5e-4) << name;
        EXPECT_NEAR(laid.area_error, 0, 1e-3) << name;
    }
}

TEST_F(Remeshing, LeavesTilesCutAlongTheEdgesOfAMeshBeforeAnyWork) {
    RIPSTOP_REQUIRE_SHARED(file, "faults/shapes/plush_patches.obj");
    ReadOptions options;
    options.unit = LengthUnit{"m", 1};
    options.remesh = automatic;
    const EnvelopeInput input = read_input(file, options);
    options.remesh = {};
    const Envelope as_drawn = read_input(file, options).envelope;
    for (std::size_t t = 0; t < as_drawn.tiles.size(); ++t)
        EXPECT_EQ(input.envelope.tiles[t].mesh.triangles, as_drawn.tiles[t].mesh.triangles);
    EXPECT_THAT(input.remarks, ::testing::Contains(HasSubstr("cut along the edges of a mesh")));
}

/// Expects every tile to be remeshed or unchanged, and a remark to count the unchanged ones.
void expect_failures_as_they_were(const Envelope& before, const Envelope& after,
                                  const std::vector<std::string>& remarks, const std::string& why) {
    int kept = 0;
    for (std::size_t t = 0; t < before.tiles.size(); ++t) {
        if (after.tiles[t].remeshed) continue;
        ++kept;
        EXPECT_EQ(after.tiles[t].mesh.positions, before.tiles[t].mesh.positions);
        EXPECT_EQ(after.tiles[t].mesh.triangles, before.tiles[t].mesh.triangles);
        EXPECT_EQ(after.tiles[t].boundary, before.tiles[t].boundary);
    }
    ASSERT_GT(kept, 0) << "nothing failed: " << ::testing::PrintToString(remarks);
    EXPECT_THAT(remarks, ::testing::Contains(::testing::AllOf(HasSubstr("not remeshed"), HasSubstr(why))));
}

TEST_F(Remeshing, LeavesTilesWhoseSeamsWouldBeOthers) {
    // So coarse that the sides of some seams are close for part of their length only.
    Envelope envelope = make_envelope(meshed_apart({.gores = 6, .panels = 3}, 3), {});
    const Envelope before = envelope;
    const std::vector<std::string> remarks = remesh_envelope(envelope, by_length(0.6));
    expect_failures_as_they_were(before, envelope, remarks, "the seams would not be found again");
    EXPECT_EQ(envelope.seams.size(), before.seams.size());
}

TEST_F(Remeshing, KeepsTheCreasesOfACrumpledTile) {
    // Crumpled at the size of its triangles, so nearly every edge is a crease at any edge length.
    std::mt19937 random(3);
    Envelope envelope = one_tile(grid(
        30, 30, [&](double u, double v) { return Vec3(0.06 * static_cast<double>(random() % 1000) / 1000, u, v); }));
    const double area = surface_area(envelope.tiles[0].mesh);
    const std::vector<std::string> remarks = remesh_envelope(envelope, by_length(0.1));
    ASSERT_TRUE(envelope.tiles[0].remeshed) << ::testing::PrintToString(remarks);
    EXPECT_NEAR(surface_area(envelope.tiles[0].mesh) / area, 1, 5e-4);
}

/// A square metre with waves in both directions, smooth for its triangles.
TriangleMesh egg_box(int waves, int cells, double steepest) {
    const double turns = 2 * std::numbers::pi * waves, height = std::tan(steepest) / turns;
    return grid(cells, cells,
                [=](double u, double v) { return Vec3(height * std::sin(turns * u) * std::sin(turns * v), u, v); });
}

TEST_F(Remeshing, LeavesATileThatWouldFold) {
    // Flanks of 68 degrees, on edges about as long as half a wave even if smaller ones are tried.
    Envelope envelope = one_tile(egg_box(2, 80, 68 * degree));
    const Envelope before = envelope;
    const std::vector<std::string> remarks = remesh_envelope(envelope, by_length(2));
    expect_failures_as_they_were(before, envelope, remarks, "the new triangles would fold over");
}

TEST_F(Remeshing, LeavesATileThatWouldLoseItsArea) {
    // No triangle is turned by 60 degrees if none is steeper than 28; the waves have 6 % of the area.
    Envelope envelope = one_tile(egg_box(3, 60, 28 * degree));
    const Envelope before = envelope;
    const std::vector<std::string> remarks = remesh_envelope(envelope, by_length(2));
    expect_failures_as_they_were(before, envelope, remarks, "its area would change");
}

TEST_F(Remeshing, RefusesALengthThatMeansNothing) {
    Envelope envelope = one_tile(octant(10));
    EXPECT_THROW(remesh_envelope(envelope, by_length(0)), InputError);
    EXPECT_THROW(remesh_envelope(envelope, by_length(std::nan(""))), InputError);
    EXPECT_THROW(remesh_envelope(envelope, by_length(1e-6)), InputError);
}

TEST_F(Remeshing, AtALengthBeyondTheTileLeavesItSomeTrianglesAndItsArea) {
    // The minimum number of triangles would lose 1 % of the area, so smaller ones are used: not many, but enough.
    const TriangleMesh mesh = sphere_grid(half, 12, 12);
    const Tile tile = remeshed(mesh, by_length(50));
    EXPECT_GT(tile.mesh.triangle_count(), 8);
    EXPECT_LT(tile.mesh.triangle_count(), mesh.triangle_count() / 2);
    const double of_sphere = 2 * half * 2 * std::sin(half), lacking = 1 - surface_area(mesh) / of_sphere;
    EXPECT_NEAR(surface_area(tile.mesh) / surface_area(mesh), 1, 5e-4 + 1.5 * lacking);
}

}  // namespace remesh_envelope_test
}  // namespace ripstop
