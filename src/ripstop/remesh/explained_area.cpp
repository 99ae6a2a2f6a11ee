#include "ripstop/remesh/explained_area.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "ripstop/base/units.h"
#include "ripstop/geometry/triangle.h"

namespace ripstop {
namespace {

constexpr double meant = 45 * degree;
constexpr double room = 1.5;

/// The mean square of the turns from triangle to triangle.
double mean_square_turn(const TriangleMesh& mesh, const Adjacency& adjacency) {
    double squares = 0, weights = 0;
    for (const int h : adjacency.edges()) {
        if (adjacency.is_boundary(h)) continue;
        const Vec3 a = area_vector(mesh, Adjacency::triangle(h)), b = area_vector(mesh, Adjacency::triangle(adjacency.twin(h)));
        const double turn = std::atan2(a.cross(b).norm(), a.dot(b));
        if (turn > meant) continue;
        squares += (a.norm() + b.norm()) * turn * turn;
        weights += a.norm() + b.norm();
    }
    return weights > 0 ? squares / weights : 0;
}

/// The mean of the angles that are missing, or too many, about the interior vertices.
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

double area_outside_edges(const Tile& tile, const Adjacency& adjacency, const BoundarySlopes& slopes) {
    std::vector<Eigen::Index> place(static_cast<std::size_t>(tile.mesh.vertex_count()), -1);
    for (std::size_t i = 0; i < tile.boundary.size(); ++i)
        place[static_cast<std::size_t>(tile.boundary[i])] = static_cast<Eigen::Index>(i);
    double sum = 0;
    for (const int h : adjacency.edges()) {
        if (!adjacency.is_boundary(h)) continue;
        const Eigen::Index e = place[static_cast<std::size_t>(adjacency.from(h))];
        const Vec3 chord = tile.mesh.positions.row(adjacency.to(h)) - tile.mesh.positions.row(adjacency.from(h));
        const Vec3 outward = chord.cross(area_vector(tile.mesh, Adjacency::triangle(h)).normalized());
        sum += (slopes.start.row(e) - slopes.end.row(e)).dot(outward) / 12;
    }
    return sum;
}

}  // namespace

double ExplainedArea::beyond(double gain) const {
    const double rest = gain - boundary;
    return std::max(0.0, std::abs(rest) - room * bending);
}

ExplainedArea explained_area(const Tile& tile, const Adjacency& adjacency, const BoundarySlopes& slopes) {
    ExplainedArea explained;
    explained.boundary = area_outside_edges(tile, adjacency, slopes) / surface_area(tile.mesh);
    explained.bending = mean_square_turn(tile.mesh, adjacency) / 8 + mean_defect(tile) / 6;
    return explained;
}

}  // namespace ripstop
