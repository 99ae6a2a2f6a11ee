#include "ripstop/remesh/explained_area.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "ripstop/base/index.h"
#include "ripstop/base/text/units.h"
#include "ripstop/geometry/triangle.h"

namespace ripstop {
namespace {

constexpr double meant = 45 * degree;
constexpr double room = 1.5;

/// The mean square of the dihedral turns between triangles.
double mean_square_turn(const TriangleMesh& mesh, const Adjacency& adjacency) {
    double squares = 0, weights = 0;
    for (const int h : adjacency.edges()) {
        if (adjacency.is_boundary(h)) continue;
        const Vec3 a = area_vector(mesh, Adjacency::triangle(h)),
                   b = area_vector(mesh, Adjacency::triangle(adjacency.twin(h)));
        const double turn = std::atan2(a.cross(b).norm(), a.dot(b));
        if (turn > meant) continue;
        squares += (a.norm() + b.norm()) * turn * turn;
        weights += a.norm() + b.norm();
    }
    return weights > 0 ? squares / weights : 0;
}

/// The mean of the absolute angle defects of the interior vertices, each capped at `meant` squared.
double mean_defect(const Tile& tile) {
    const TriangleMesh& mesh = tile.mesh;
    Eigen::VectorXd missing = Eigen::VectorXd::Constant(mesh.vertex_count(), 2 * std::numbers::pi);
    for (int t = 0; t < mesh.triangle_count(); ++t)
        for (int k = 0; k < 3; ++k)
            missing[mesh.triangles(t, k)] -=
                angle_at(mesh.corner(t, k), mesh.corner(t, (k + 1) % 3), mesh.corner(t, (k + 2) % 3));
    for (const int v : tile.boundary) missing[v] = 0;
    const auto inner = mesh.vertex_count() - static_cast<Eigen::Index>(tile.boundary.size());
    return inner > 0 ? missing.cwiseAbs().cwiseMin(meant * meant).sum() / static_cast<double>(inner) : 0;
}

Vec3 point_on_old_boundary(const Tile& tile, const BoundaryPlace& place) {
    const std::size_t edge = static_cast<std::size_t>(place.edge);
    const Vec3 start = tile.mesh.positions.row(tile.boundary[edge]);
    const Vec3 end = tile.mesh.positions.row(tile.boundary[(edge + 1) % tile.boundary.size()]);
    return start + place.share * (end - start);
}

/// The area between the old edges and the new ones, positive outward: a polygon between every two nodes, projected
/// along the normal of the old triangles there.
double area_between_boundaries(const Tile& tile, const Adjacency& adjacency, const NewBoundary& boundary) {
    const int count = static_cast<int>(tile.boundary.size());
    std::vector<int> place(static_cast<std::size_t>(tile.mesh.vertex_count()), -1);
    for (int i = 0; i < count; ++i) place[at(tile.boundary[at(i)])] = i;
    std::vector<Vec3> normals(static_cast<std::size_t>(count), Vec3::Zero());
    for (const int h : adjacency.edges())
        if (adjacency.is_boundary(h))
            normals[at(place[at(adjacency.from(h))])] = area_vector(tile.mesh, Adjacency::triangle(h)).normalized();
    double sum = 0;
    for (std::size_t i = 0; i < boundary.nodes.size(); ++i) {
        const BoundaryNode &first = boundary.nodes[i], &second = boundary.nodes[(i + 1) % boundary.nodes.size()];
        int edges = (second.place.edge - first.place.edge + count) % count;
        if (edges == 0 && second.place.share <= first.place.share) edges = count;
        std::vector<Vec3> polygon{first.position, second.position, point_on_old_boundary(tile, second.place)};
        for (int e = edges; e > 0; --e)
            polygon.push_back(tile.mesh.positions.row(tile.boundary[at((first.place.edge + e) % count)]));
        polygon.push_back(point_on_old_boundary(tile, first.place));
        Vec3 normal = Vec3::Zero(), area = Vec3::Zero();
        for (int e = 0; e < edges + (second.place.share > 0 ? 1 : 0); ++e)
            normal += normals[at((first.place.edge + e) % count)];
        for (std::size_t k = 1; k + 1 < polygon.size(); ++k)
            area += (polygon[k] - polygon[0]).cross(polygon[k + 1] - polygon[0]) / 2;
        sum += area.dot(normal.normalized());
    }
    return sum;
}

}  // namespace

double ExplainedArea::beyond(double gain) const {
    const double rest = gain - boundary;
    return std::max(0.0, std::abs(rest) - room * bending);
}

ExplainedArea explained_area(const Tile& tile, const Adjacency& adjacency, const NewBoundary& boundary) {
    ExplainedArea explained;
    explained.boundary = area_between_boundaries(tile, adjacency, boundary) / surface_area(tile.mesh);
    explained.bending = mean_square_turn(tile.mesh, adjacency) / 8 + mean_defect(tile) / 6;
    return explained;
}

}  // namespace ripstop
