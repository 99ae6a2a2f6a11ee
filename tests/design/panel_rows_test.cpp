#include "ripstop/design/tools/panel_rows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>

#include "ripstop/mesh/adjacency.h"
#include "ripstop/mesh/disk.h"

namespace ripstop {
namespace strip_test {

/// The rows laid out one unit apart, each over [-1, 1].
TriangleMesh laid_out(const RowColumns& columns) {
    TriangleMesh mesh;
    mesh.triangles = triangulate_rows(columns);
    mesh.positions = Points3::Zero(mesh.triangles.maxCoeff() + 1, 3);
    int v = 0;
    for (std::size_t k = 0; k < columns.size(); ++k)
        for (int i = 0; i <= columns[k]; ++i)
            mesh.positions.row(v++) << (columns[k] == 0 ? 0 : 2.0 * i / columns[k] - 1), static_cast<double>(k), 0;
    return mesh;
}

const RowColumns many[] = {{1, 2, 1},    {4, 5, 4},       {4, 5, 6, 7, 8}, {9, 10, 3, 2, 1}, {1, 8, 3},
                           {4, 3, 2, 0}, {0, 2, 3, 2, 0}, {6, 9, 4},       {2, 3, 2, 3, 2},  {0, 2, 0}};

TEST(TriangulateRows, MakesADiskThatFacesUp) {
    for (const RowColumns& columns : many) {
        const TriangleMesh mesh = laid_out(columns);
        EXPECT_NO_THROW(require_disk(mesh, Adjacency(mesh.triangles, mesh.vertex_count()), "strip"));
        EXPECT_GT(area_vector(mesh).z(), 0);
        EXPECT_NEAR(area_vector(mesh).z(), surface_area(mesh), 1e-12) << "no triangle is turned over";
    }
}

TEST(TriangulateRows, IsItsOwnMirrorImage) {
    for (const RowColumns& columns : many) {
        std::vector<int> mirror;
        int start = 0;
        for (const int n : columns) {
            for (int i = 0; i <= n; ++i) mirror.push_back(start + n - i);
            start += n + 1;
        }
        const Triangles triangles = triangulate_rows(columns);
        std::set<std::set<int>> these, mirrored;
        for (Eigen::Index t = 0; t < triangles.rows(); ++t) {
            std::set<int> corners, reflected;
            for (int k = 0; k < 3; ++k) {
                corners.insert(triangles(t, k));
                reflected.insert(mirror[static_cast<std::size_t>(triangles(t, k))]);
            }
            these.insert(corners);
            mirrored.insert(reflected);
        }
        EXPECT_EQ(these, mirrored);
    }
}

TEST(Stagger, KeepsTheSeamsAndAlternatesParity) {
    const std::vector<RowWish> wishes{{5.2, 1}, {5.0, 1}, {4.6, 1}, {4.1, 1}, {3.9, 1}, {3.4, 1}};
    ASSERT_TRUE(parity_fits(5, 4, 5));
    const RowColumns columns = stagger(wishes, 5, 4);
    EXPECT_EQ(columns.front(), 5);
    EXPECT_EQ(columns.back(), 4);
    for (std::size_t k = 1; k < columns.size(); ++k) EXPECT_EQ(std::abs(columns[k] - columns[k - 1]) % 2, 1) << k;
    EXPECT_GT(columns[1], 5);
    EXPECT_GT(columns[4], 4);
}

TEST(Stagger, GivesAPointAFanOfTwo) {
    ASSERT_TRUE(parity_fits(0, 3, 4));
    const RowColumns columns = stagger({{0, 1}, {0.5, 1}, {1, 1}, {2.5, 1}, {3, 1}}, 0, 3);
    EXPECT_EQ(columns, (RowColumns{0, 2, 3, 4, 3}));
}

}  // namespace strip_test
}  // namespace ripstop
