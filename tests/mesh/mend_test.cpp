/// Mends the defects that exporters leave; keeps what designers intend.
#include "ripstop/mesh/change/mend.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "ripstop/base/error.h"
#include "ripstop/base/text/units.h"
#include "ripstop/mesh/adjacency.h"
#include "ripstop/mesh/disk.h"
#include "support/shapes.h"

namespace ripstop {
namespace mend_test {

using std::numbers::pi;

bool is_disk(const TriangleMesh& mesh) {
    try {
        require_disk(mesh, Adjacency(mesh.triangles, mesh.vertex_count()), "it");
        return true;
    } catch (const InputError&) {
        return false;
    }
}

TriangleMesh mesh_of(std::initializer_list<Vec3> points, std::initializer_list<std::array<int, 3>> triangles) {
    TriangleMesh mesh{Points3(static_cast<Eigen::Index>(points.size()), 3),
                      Triangles(static_cast<Eigen::Index>(triangles.size()), 3)};
    Eigen::Index row = 0;
    for (const Vec3& point : points) mesh.positions.row(row++) = point.transpose();
    row = 0;
    for (const auto& [a, b, c] : triangles) mesh.triangles.row(row++) << a, b, c;
    return mesh;
}

void add_triangle(TriangleMesh& mesh, int a, int b, int c) {
    mesh.triangles.conservativeResize(mesh.triangles.rows() + 1, 3);
    mesh.triangles.row(mesh.triangles.rows() - 1) << a, b, c;
}

int add_vertex(TriangleMesh& mesh, const Vec3& at) {
    mesh.positions.conservativeResize(mesh.positions.rows() + 1, 3);
    mesh.positions.row(mesh.positions.rows() - 1) = at.transpose();
    return mesh.vertex_count() - 1;
}

/// The mesh with three separate vertices for each triangle.
TriangleMesh torn(const TriangleMesh& mesh) {
    TriangleMesh soup{Points3(3 * mesh.triangle_count(), 3), Triangles(mesh.triangle_count(), 3)};
    for (int t = 0; t < mesh.triangle_count(); ++t)
        for (int k = 0; k < 3; ++k) {
            soup.positions.row(3 * t + k) = mesh.corner(t, k).transpose();
            soup.triangles(t, k) = 3 * t + k;
        }
    return soup;
}

/// The mesh with a copy of vertex `v` for each of its triangles.
TriangleMesh torn_at(TriangleMesh mesh, int v) {
    bool first = true;
    for (int t = 0; t < mesh.triangle_count(); ++t)
        for (int k = 0; k < 3; ++k) {
            if (mesh.triangles(t, k) != v) continue;
            if (!first) mesh.triangles(t, k) = add_vertex(mesh, mesh.positions.row(v));
            first = false;
        }
    return mesh;
}

void expect_same_surface(const TriangleMesh& mended, const TriangleMesh& sound) {
    EXPECT_TRUE(is_disk(mended));
    EXPECT_EQ(mended.vertex_count(), sound.vertex_count());
    EXPECT_EQ(mended.triangle_count(), sound.triangle_count());
    EXPECT_NEAR(surface_area(mended), surface_area(sound), 1e-12 * surface_area(sound));
}

TEST(Mend, LeavesSoundMeshesAsTheyAreBitByBit) {
    for (const auto& shapes : {testing::developable_shapes(), testing::curved_shapes()})
        for (const testing::Shape& shape : shapes) {
            const MendedMesh mended = mend_mesh(shape.mesh);
            EXPECT_FALSE(mended.any()) << shape.name;
            EXPECT_EQ(mended.mesh.positions, shape.mesh.positions) << shape.name;
            EXPECT_EQ(mended.mesh.triangles, shape.mesh.triangles) << shape.name;
        }
}

TEST(Mend, JoinsWhatATriangleWithoutAreaJoins) {
    const TriangleMesh mesh =
        mesh_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0.1}, {0, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}, {3, 2, 4}});
    const MendedMesh mended = mend_mesh(mesh);
    EXPECT_EQ(mended.joined, 1);
    EXPECT_EQ(mended.flat, 1);
    EXPECT_EQ(mended.place, Vec3(0, 1, 0));
    EXPECT_EQ(mended.mesh.triangles, mesh.triangles.topRows(2));
    EXPECT_EQ(mended.mesh.vertex_count(), 4);
    EXPECT_EQ(mended.becomes, (std::vector<int>{0, 1, 2, 3, 3}));
}

TEST(Mend, JoinsTheRowsOfVerticesAtThePoles) {
    // a gore of a sphere as a grid whose first and last rows are points
    TriangleMesh grid = testing::grid(4, 12, [](double u, double v) {
        const double lat = pi * (v - 0.5), lon = 0.3 * u;
        return Vec3(std::cos(lat) * std::cos(lon), std::cos(lat) * std::sin(lon), std::sin(lat));
    });
    for (int i = 0; i <= 4; ++i) {
        grid.positions.row(i) << 0, 0, -1;
        grid.positions.row(12 * 5 + i) << 0, 0, 1;
    }
    const MendedMesh mended = mend_mesh(grid);
    EXPECT_EQ(mended.joined, 8);
    EXPECT_EQ(mended.flat, 8);
    EXPECT_TRUE(is_disk(mended.mesh));
    EXPECT_EQ(mended.mesh.triangle_count(), 2 * 4 * 12 - 8);
    EXPECT_EQ(mended.mesh.vertex_count(), 5 * 13 - 8);
}

TEST(Mend, GivesTheAreaOfNeedlesToTheirNeighbours) {
    // vertex 4 lies on the diagonal of a square, 5 on its right side
    for (const double off : {0.0, 1e-9, 3e-7}) {
        const Vec3 on_diagonal(0.4 + off, 0.4, 0), on_side(1, 0.5 + off, 0);
        const MendedMesh inner = mend_mesh(mesh_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, on_diagonal},
                                                   {{0, 1, 2}, {0, 2, 4}, {0, 4, 3}, {4, 2, 3}}));
        EXPECT_EQ(inner.flat, 1) << off;
        EXPECT_TRUE(is_disk(inner.mesh));
        EXPECT_NEAR(surface_area(inner.mesh), 1, 1e-6);
        EXPECT_EQ(inner.mesh.triangle_count(), 4);
        const MendedMesh outer = mend_mesh(mesh_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, on_side},
                                                   {{0, 1, 4}, {0, 4, 2}, {0, 2, 3}, {1, 2, 4}}));
        EXPECT_EQ(outer.flat, 1) << off;
        EXPECT_TRUE(is_disk(outer.mesh));
        EXPECT_EQ(outer.mesh.triangle_count(), 3) << "at the edge it goes";
    }
}

TEST(Mend, TakesOutTrianglesGivenTwiceEitherWayUp) {
    const TriangleMesh sound = testing::spherical_square(0.3, 4);
    TriangleMesh mesh = sound;
    add_triangle(mesh, mesh.triangles(3, 1), mesh.triangles(3, 2), mesh.triangles(3, 0));
    add_triangle(mesh, mesh.triangles(7, 0), mesh.triangles(7, 2), mesh.triangles(7, 1));
    const MendedMesh mended = mend_mesh(mesh);
    EXPECT_EQ(mended.doubled, 2);
    EXPECT_EQ(mended.mesh.triangles, sound.triangles);
    // a back for every face, on the same vertices and on separate ones
    TriangleMesh both = sound;
    for (int t = 0; t < sound.triangle_count(); ++t)
        add_triangle(both, sound.triangles(t, 0), sound.triangles(t, 2), sound.triangles(t, 1));
    EXPECT_EQ(mend_mesh(both).mesh.triangles, sound.triangles);
    TriangleMesh apart{Points3(2 * sound.vertex_count(), 3), both.triangles};
    apart.positions << sound.positions, sound.positions;
    apart.triangles.bottomRows(sound.triangle_count()).array() += sound.vertex_count();
    EXPECT_EQ(mend_mesh(apart).mesh.triangles, sound.triangles);
}

TEST(Mend, TakesOutVerticesOfNoTriangle) {
    TriangleMesh mesh = testing::rectangle(1, 1, 2, 2);
    add_vertex(mesh, {7, 7, 7});
    const MendedMesh mended = mend_mesh(mesh);
    EXPECT_EQ(mended.unused, 1);
    EXPECT_EQ(mended.place, Vec3(7, 7, 7));
    EXPECT_TRUE(is_disk(mended.mesh));
}

TEST(Mend, WeldsAMeshWhoseFacesHaveVerticesOfTheirOwn) {
    for (const testing::Shape& shape : testing::curved_shapes())
        expect_same_surface(mend_mesh(torn(shape.mesh)).mesh, shape.mesh);
}

TEST(Mend, WeldsASlitOfNoWidthWithin) {
    // a row of inner vertices is doubled: one copy above it, one below
    TriangleMesh mesh = testing::rectangle(1, 1, 6, 6);
    const TriangleMesh sound = mesh;
    for (const int v : {22, 23, 24, 25}) {
        if (v == 22 || v == 25) continue;  // the slit's ends stay single
        const int copy = add_vertex(mesh, mesh.positions.row(v));
        for (int t = 0; t < mesh.triangle_count(); ++t) {
            const bool above =
                (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)).y() / 3 > mesh.positions(v, 1);
            for (int k = 0; k < 3; ++k)
                if (above && mesh.triangles(t, k) == v) mesh.triangles(t, k) = copy;
        }
    }
    ASSERT_FALSE(is_disk(mesh)) << "two boundary loops";
    expect_same_surface(mend_mesh(mesh).mesh, sound);
}

TEST(Mend, WeldsTheTipOfAGore) {
    for (const int columns : {1, 2, 3, 8}) {
        const TriangleMesh sound = testing::lune(2 * pi / 24, columns, 12);
        std::vector<int> fan(static_cast<std::size_t>(sound.vertex_count()), 0);
        for (const int v : sound.triangles.reshaped()) ++fan[static_cast<std::size_t>(v)];
        TriangleMesh mesh = sound;
        for (int v = 0; v < sound.vertex_count(); ++v)
            if (std::abs(sound.positions(v, 2)) > 1 - 1e-9) mesh = torn_at(mesh, v);
        const MendedMesh mended = mend_mesh(mesh);
        EXPECT_EQ(mended.welded, 2 * (columns - 1)) << columns;
        expect_same_surface(mended.mesh, sound);
    }
}

/// A gore of the unit sphere with blunt ends of total width `tip` instead of points.
TriangleMesh blunt_gore(int columns, double tip) {
    const double angle = 2 * pi / 24, most = pi / 2 - tip / angle;
    return testing::grid(columns, 12, [=](double u, double v) {
        const double latitude = most * (2 * v - 1), longitude = angle * (u - 0.5);
        return Vec3(std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude),
                    std::sin(latitude));
    });
}

TEST(CloseTips, TakesATipNarrowerThanAskedAsThePointInItsMiddle) {
    for (const int columns : {1, 2, 4})
        for (const double tip : {1e-9, 1e-6, 1e-5, 4e-4}) {
            const TriangleMesh mesh = blunt_gore(columns, tip);
            const MendedMesh mended = mend_mesh(mesh, {false, 5e-4});
            EXPECT_EQ(mended.closed, 2) << columns << " " << tip;
            EXPECT_EQ(mended.flat, 0) << "the triangles of a tip are no fault of their own";
            EXPECT_EQ(mended.mesh.vertex_count(), mesh.vertex_count() - 2 * columns);
            EXPECT_TRUE(is_disk(mended.mesh));
            const Vec3 ends = mesh.positions.row(0) + mesh.positions.row(columns);
            EXPECT_LT((Vec3(mended.mesh.positions.row(0)) - ends / 2).norm(), 1e-15);
            EXPECT_NEAR(surface_area(mended.mesh), surface_area(mesh), tip);
            EXPECT_EQ(mended.triangle.size(), static_cast<std::size_t>(mended.mesh.triangle_count()));
        }
}

TEST(CloseTips, ClosesThemHoweverTheFileRoundsThem) {
    TriangleMesh mesh = blunt_gore(4, 1e-5);
    mesh.positions = (mesh.positions * 1e6).array().round() / 1e6;
    EXPECT_EQ(mend_mesh(mesh, {false, 5e-4}).closed, 2);
}

TEST(CloseTips, KeepsWiderTipsNarrowSlotsAndShortEdgesOfAStraightSide) {
    EXPECT_FALSE(mend_mesh(blunt_gore(4, 6e-4), {false, 5e-4}).any());
    const TriangleMesh slotted = mesh_of({{0, 0, 0},
                                          {2, 0, 0},
                                          {2, 1, 0},
                                          {1.0001, 1, 0},
                                          {1.0001, 0.3, 0},
                                          {0.9999, 0.3, 0},
                                          {0.9999, 1, 0},
                                          {0, 1, 0}},
                                         {{0, 1, 5}, {1, 4, 5}, {1, 2, 4}, {2, 3, 4}, {0, 5, 7}, {5, 6, 7}});
    EXPECT_FALSE(mend_mesh(slotted, {false, 5e-4}).any());
    const TriangleMesh straight =
        mesh_of({{0, 0, 0}, {1, 0, 0}, {1.0001, 0, 0}, {2, 0, 0}, {1, 1, 0}}, {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}});
    EXPECT_FALSE(mend_mesh(straight, {false, 5e-4}).any());
}

TEST(Mend, KeepsDarts) {
    // closed darts: of several edges; of one edge from a straight side; of one edge that removes an angle
    TriangleMesh mesh = testing::rectangle(2, 1, 8, 8);
    for (int j = 0; j < 4; ++j) {
        const int v = 9 * j + 4, copy = add_vertex(mesh, mesh.positions.row(v));
        for (int t = 0; t < mesh.triangle_count(); ++t) {
            const bool right =
                (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)).x() / 3 > mesh.positions(v, 0);
            for (int k = 0; k < 3; ++k)
                if (right && mesh.triangles(t, k) == v) mesh.triangles(t, k) = copy;
        }
        EXPECT_FALSE(mend_mesh(mesh).any()) << j;
        EXPECT_TRUE(is_disk(mesh));
    }
    const double edge = 1;  // a three-sided pyramid, cut open along one of its edges
    const TriangleMesh pyramid = mesh_of(
        {{edge, 0, 0}, {-0.5, 0.8660254037844386, 0}, {-0.5, -0.8660254037844386, 0}, {0, 0, 0.8}, {edge, 0, 0}},
        {{0, 1, 3}, {1, 2, 3}, {2, 4, 3}});
    EXPECT_FALSE(mend_mesh(pyramid).any());
}

TEST(Mend, KeepsATubeCutOpen) {
    EXPECT_FALSE(mend_mesh(testing::cylinder(1, 2 * pi, 1, 12, 1)).any());
}

TEST(Mend, LeavesWhatIsNoDiskToBeNamed) {
    TriangleMesh two = testing::rectangle(1, 1, 1, 1);
    const int a = add_vertex(two, {5, 0, 0}), b = add_vertex(two, {6, 0, 0}), c = add_vertex(two, {5, 1, 0});
    add_triangle(two, a, b, c);
    EXPECT_FALSE(mend_mesh(two).any());
    EXPECT_FALSE(is_disk(mend_mesh(two).mesh));
}

}  // namespace mend_test
}  // namespace ripstop
