#include "support/poor_meshes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "ripstop/geometry/triangle.h"
#include "ripstop/mesh/adjacency.h"
#include "support/shapes.h"

namespace ripstop::testing {
namespace {

Vec3 on_sphere(double longitude, double latitude) {
    return {std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude), std::sin(latitude)};
}

}  // namespace

TriangleMesh sphere_grid(double half, int columns, int rows) {
    return grid(
        columns, rows, [half](double u, double v) { return on_sphere(half * (2 * u - 1), half * (2 * v - 1)); }, true);
}

TriangleMesh random_diagonals(double half, int columns, int rows, unsigned seed) {
    TriangleMesh mesh = sphere_grid(half, columns, rows);
    std::mt19937 random(seed);
    for (int cell = 0; cell < columns * rows; ++cell) {
        const int a = cell / columns * (columns + 1) + cell % columns, b = a + 1, c = b + columns + 1, d = c - 1;
        if (random() % 2 == 0) {
            mesh.triangles.row(2 * cell) << a, b, d;
            mesh.triangles.row(2 * cell + 1) << b, c, d;
        } else {
            mesh.triangles.row(2 * cell) << a, b, c;
            mesh.triangles.row(2 * cell + 1) << a, c, d;
        }
    }
    return mesh;
}

TriangleMesh jumbled(double half, int columns, int rows, double share, unsigned seed) {
    std::mt19937 random(seed);
    const auto push = [&] { return share * (2 * (static_cast<double>(random() % 10001) / 10000) - 1); };
    return grid(
        columns, rows,
        [&](double u, double v) {
            const bool inside = u > 0 && u < 1 && v > 0 && v < 1;
            const double du = inside ? push() / columns : 0, dv = inside ? push() / rows : 0;
            return on_sphere(half * (2 * (u + du) - 1), half * (2 * (v + dv) - 1));
        },
        true);
}

TriangleMesh with_dense_boundary(double half, int columns, int rows, int extra) {
    const TriangleMesh mesh = sphere_grid(half, columns, rows);
    const Adjacency adjacency(mesh.triangles, mesh.vertex_count());
    std::vector<Vec3> points;
    for (int v = 0; v < mesh.vertex_count(); ++v) points.push_back(mesh.positions.row(v));
    std::vector<std::array<int, 3>> triangles;
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        int side = -1;
        for (int k = 0; k < 3; ++k)
            if (adjacency.is_boundary(3 * t + k)) side = k;
        if (side < 0) {
            triangles.push_back({mesh.triangles(t, 0), mesh.triangles(t, 1), mesh.triangles(t, 2)});
            continue;
        }
        const int a = mesh.triangles(t, side), b = mesh.triangles(t, (side + 1) % 3);
        const int apex = mesh.triangles(t, (side + 2) % 3);
        const Vec3 p = mesh.positions.row(a), q = mesh.positions.row(b);
        int last = a;
        for (int i = 1; i <= extra; ++i) {
            const double share = static_cast<double>(i) / (extra + 1);
            const auto angle = [&](auto of) { return (1 - share) * of(p) + share * of(q); };
            points.push_back(on_sphere(angle([](const Vec3& x) { return std::atan2(x.y(), x.x()); }),
                                       angle([](const Vec3& x) { return std::asin(x.z()); })));
            triangles.push_back({last, static_cast<int>(points.size()) - 1, apex});
            last = static_cast<int>(points.size()) - 1;
        }
        triangles.push_back({last, b, apex});
    }
    TriangleMesh dense{Points3(static_cast<Eigen::Index>(points.size()), 3),
                       Triangles(static_cast<Eigen::Index>(triangles.size()), 3)};
    for (std::size_t v = 0; v < points.size(); ++v) dense.positions.row(static_cast<Eigen::Index>(v)) = points[v];
    for (std::size_t t = 0; t < triangles.size(); ++t)
        dense.triangles.row(static_cast<Eigen::Index>(t)) << triangles[t][0], triangles[t][1], triangles[t][2];
    return dense;
}

int locked_edges(const TriangleMesh& mesh) {
    const Adjacency adjacency(mesh.triangles, mesh.vertex_count());
    std::vector<bool> outer(static_cast<std::size_t>(mesh.vertex_count()), false);
    for (const int h : adjacency.edges())
        if (adjacency.is_boundary(h))
            outer[static_cast<std::size_t>(adjacency.from(h))] = outer[static_cast<std::size_t>(adjacency.to(h))] =
                true;
    const auto is_ear = [&](int t) {
        int sides = 0;
        for (int k = 0; k < 3; ++k) sides += adjacency.is_boundary(3 * t + k) ? 1 : 0;
        return sides == 2;
    };
    int count = 0;
    for (const int h : adjacency.edges())
        if (!adjacency.is_boundary(h) && outer[static_cast<std::size_t>(adjacency.from(h))] &&
            outer[static_cast<std::size_t>(adjacency.to(h))] && !is_ear(Adjacency::triangle(h)) &&
            !is_ear(Adjacency::triangle(adjacency.twin(h))))
            ++count;
    return count;
}

double least_angle(const TriangleMesh& mesh) {
    double least = 10;
    for (int t = 0; t < mesh.triangle_count(); ++t)
        for (int k = 0; k < 3; ++k)
            least =
                std::min(least, angle_at(mesh.corner(t, k), mesh.corner(t, (k + 1) % 3), mesh.corner(t, (k + 2) % 3)));
    return least;
}

}  // namespace ripstop::testing
