#include "ripstop/design/tools/tiles_summary.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "ripstop/geometry/triangle.h"
#include "ripstop/mesh/adjacency.h"
#include "ripstop/mesh/boundary.h"
#include "ripstop/mesh/disk.h"
#include "ripstop/model/tile/tile.h"
#include "ripstop/tile/make_tile.h"

namespace ripstop {
namespace {

/// Six times the volume of the tetrahedron between the origin and a triangle.
double cone(const Vec3& a, const Vec3& b, const Vec3& c) {
    return a.dot(b.cross(c));
}

double closed_volume(const TriangleMesh& mesh, const std::vector<std::vector<int>>& loops) {
    double sum = 0;
    for (int t = 0; t < mesh.triangle_count(); ++t)
        sum += cone(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2));
    for (const std::vector<int>& loop : loops) {
        Vec3 centre = Vec3::Zero();
        for (const int v : loop) centre += Vec3(mesh.positions.row(v)) / static_cast<double>(loop.size());
        for (std::size_t i = 0; i < loop.size(); ++i)
            sum += cone(mesh.positions.row(loop[(i + 1) % loop.size()]), mesh.positions.row(loop[i]), centre);
    }
    return sum / 6;
}

void measure_triangles(const TriangleMesh& mesh, TilesSummary& summary) {
    for (int t = 0; t < mesh.triangle_count(); ++t)
        for (int k = 0; k < 3; ++k) {
            const Vec3 a = mesh.corner(t, k);
            const Vec3 b = mesh.corner(t, (k + 1) % 3);
            summary.edge_min = std::min(summary.edge_min, (b - a).norm());
            summary.edge_max = std::max(summary.edge_max, (b - a).norm());
            summary.angle_min = std::min(summary.angle_min, angle_at(a, b, mesh.corner(t, (k + 2) % 3)));
        }
}

Vec3 normal(const TriangleMesh& mesh, int t) {
    return (mesh.corner(t, 1) - mesh.corner(t, 0)).cross(mesh.corner(t, 2) - mesh.corner(t, 0));
}

void measure_turns(const TriangleMesh& mesh, TilesSummary& summary) {
    const Adjacency adjacency(mesh.triangles, mesh.vertex_count());
    for (const int h : adjacency.edges()) {
        if (adjacency.is_boundary(h)) continue;
        const Vec3 one = normal(mesh, Adjacency::triangle(h));
        const Vec3 other = normal(mesh, Adjacency::triangle(adjacency.twin(h)));
        const double length = (mesh.positions.row(adjacency.to(h)) - mesh.positions.row(adjacency.from(h))).norm();
        const double turn = std::atan2(one.cross(other).norm(), one.dot(other));
        const double height = (one.norm() + other.norm()) / (2 * length);
        summary.turn_max = std::max(summary.turn_max, turn);
        summary.chord_error = std::max(summary.chord_error, turn * height / 8);
    }
}

void measure_extent(const TriangleMesh& mesh, TilesSummary& summary) {
    const Vec3 axis = longest_axis(mesh);
    const Vec3 across = axis.cross(area_vector(mesh)).normalized();
    const auto extent = [&mesh](const Vec3& direction) {
        const Eigen::VectorXd along = mesh.positions * direction;
        return along.maxCoeff() - along.minCoeff();
    };
    summary.tile_length = std::max(summary.tile_length, extent(axis));
    summary.tile_width = std::max(summary.tile_width, extent(across));
}

}  // namespace

TriangleMesh welded(const std::vector<NamedMesh>& tiles) {
    std::map<std::array<double, 3>, int> numbers;
    std::vector<Vec3> places;
    std::vector<Eigen::RowVector3i> triangles;
    for (const NamedMesh& tile : tiles)
        for (int t = 0; t < tile.mesh.triangle_count(); ++t) {
            Eigen::RowVector3i triangle;
            for (int k = 0; k < 3; ++k) {
                const Vec3 p = tile.mesh.corner(t, k);
                const auto [at, fresh] = numbers.try_emplace({p.x(), p.y(), p.z()}, static_cast<int>(places.size()));
                if (fresh) places.push_back(p);
                triangle[k] = at->second;
            }
            triangles.push_back(triangle);
        }
    TriangleMesh mesh;
    mesh.positions.resize(static_cast<Eigen::Index>(places.size()), 3);
    mesh.triangles.resize(static_cast<Eigen::Index>(triangles.size()), 3);
    for (std::size_t i = 0; i < places.size(); ++i) mesh.positions.row(static_cast<Eigen::Index>(i)) = places[i];
    for (std::size_t i = 0; i < triangles.size(); ++i) mesh.triangles.row(static_cast<Eigen::Index>(i)) = triangles[i];
    return mesh;
}

TilesSummary measure_tiles(const std::vector<NamedMesh>& tiles) {
    TilesSummary summary;
    summary.tiles = static_cast<int>(tiles.size());
    summary.edge_min = std::numeric_limits<double>::infinity();
    summary.angle_min = std::numbers::pi;
    for (const NamedMesh& tile : tiles) {
        measure_triangles(tile.mesh, summary);
        measure_turns(tile.mesh, summary);
        measure_extent(tile.mesh, summary);
        summary.area += surface_area(tile.mesh);
    }
    const TriangleMesh whole = welded(tiles);
    const Adjacency adjacency(whole.triangles, whole.vertex_count());
    const auto loops = boundary_loops(adjacency);
    summary.triangles = whole.triangle_count();
    summary.euler = whole.vertex_count() - static_cast<int>(adjacency.edges().size()) + whole.triangle_count();
    summary.openings = static_cast<int>(loops.size());
    for (const std::vector<int>& loop : loops) summary.rim += edge_lengths(whole.positions, closed(loop)).sum();
    summary.volume = closed_volume(whole, loops);
    summary.height = whole.positions.col(2).maxCoeff() - whole.positions.col(2).minCoeff();
    return summary;
}

}  // namespace ripstop
