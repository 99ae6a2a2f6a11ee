#include "ripstop/remesh/corner_normals.h"

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "ripstop/base/index.h"
#include "ripstop/geometry/triangle.h"

namespace ripstop {
namespace {

constexpr std::size_t enough = 24;  // neighbours: a cubic has nine unknowns
constexpr int most_rings = 4;
constexpr std::size_t too_many = 80;  // neighbours, as round a vertex of many needles
constexpr double nearness = 0.1;      // controls how much more weight near neighbours have than far ones
constexpr double least_normal_agreement = 0.7;

/// The triangles and neighbours of a vertex on one side of its creases.
class Surroundings {
  public:
    Surroundings(const TriangleMesh& mesh, const Adjacency& adjacency, const std::vector<bool>& crease)
        : mesh_(mesh),
          adjacency_(adjacency),
          crease_(crease),
          seen_triangle_(static_cast<std::size_t>(mesh.triangle_count()), -1),
          seen_vertex_(static_cast<std::size_t>(mesh.vertex_count()), -1) {}

    /// The corners at the vertex of `corner` that no crease separates from it, as half-edges that leave the vertex.
    std::vector<int> fan(int corner) const {
        std::vector<int> corners{corner};
        for (int h = corner;;) {  // counter-clockwise: across the incoming edge
            const int in = Adjacency::previous(h);
            if (adjacency_.is_boundary(in) || crease_[at(in)]) break;
            h = adjacency_.twin(in);
            if (h == corner) return corners;
            corners.push_back(h);
        }
        for (int h = corner; !adjacency_.is_boundary(h) && !crease_[at(h)];) {
            h = Adjacency::next(adjacency_.twin(h));
            if (h == corner) break;
            corners.push_back(h);
        }
        return corners;
    }

    /// The vertices round the fan, ring by ring until there are enough.
    std::vector<int> neighbours(const std::vector<int>& fan) {
        ++mark_;
        std::vector<int> found, front;
        const int centre = mesh_.triangles(fan.front() / 3, fan.front() % 3);
        seen_vertex_[at(centre)] = mark_;
        for (const int h : fan) take(h / 3, front, found);
        for (int ring = 1; ring < most_rings && found.size() < enough; ++ring) {
            std::vector<int> next;
            for (const int t : front)
                for (int k = 0; k < 3 && found.size() < too_many; ++k) {
                    // Neighbours share a corner, not only a side: these are rings of vertices, not of triangles.
                    for (const int h : this->fan(3 * t + k)) take(h / 3, next, found);
                }
            front = std::move(next);
        }
        return found;
    }

  private:
    void take(int t, std::vector<int>& front, std::vector<int>& found) {
        if (seen_triangle_[at(t)] == mark_) return;
        seen_triangle_[at(t)] = mark_;
        front.push_back(t);
        for (int k = 0; k < 3; ++k) {
            const int v = mesh_.triangles(t, k);
            if (seen_vertex_[at(v)] == mark_) continue;
            seen_vertex_[at(v)] = mark_;
            found.push_back(v);
        }
    }

    const TriangleMesh& mesh_;
    const Adjacency& adjacency_;
    const std::vector<bool>& crease_;
    std::vector<int> seen_triangle_, seen_vertex_;
    int mark_ = 0;
};

/// The mean normal of a fan, weighted by angle.
Vec3 mean_normal(const TriangleMesh& mesh, const std::vector<int>& fan) {
    Vec3 sum = Vec3::Zero();
    for (const int h : fan) {
        const int t = h / 3, k = h % 3;
        const Vec3 a = mesh.corner(t, k), b = mesh.corner(t, (k + 1) % 3), c = mesh.corner(t, (k + 2) % 3);
        sum += angle_at(a, b, c) * (b - a).cross(c - a).normalized();
    }
    return sum.normalized();
}

/// The normal of a fitted height function with `unknowns` terms over the plane across `up`; empty if the fit is
/// singular.
std::optional<Vec3> fitted_normal(const TriangleMesh& mesh, int vertex, const std::vector<int>& neighbours,
                                  const Vec3& up, int unknowns) {
    const int count = static_cast<int>(neighbours.size());
    if (count < unknowns + 3) return {};
    const Vec3 centre = mesh.positions.row(vertex), x_axis = up.unitOrthogonal(), y_axis = up.cross(x_axis);
    Points3 local(count, 3);
    for (int i = 0; i < count; ++i) {
        const Vec3 d = Vec3(mesh.positions.row(neighbours[at(i)])) - centre;
        local.row(i) << d.dot(x_axis), d.dot(y_axis), d.dot(up);
    }
    const double size = local.rowwise().norm().maxCoeff();
    local /= size;
    Eigen::MatrixXd terms(count, unknowns);
    Eigen::VectorXd heights(count);
    for (int i = 0; i < count; ++i) {
        const double x = local(i, 0), y = local(i, 1);
        const double weight = 1 / (nearness + local.row(i).squaredNorm());
        const std::array<double, 9> all{x, y, x * x, x * y, y * y, x * x * x, x * x * y, x * y * y, y * y * y};
        for (int k = 0; k < unknowns; ++k) terms(i, k) = weight * all[at(k)];
        heights[i] = weight * local(i, 2);
    }
    const Eigen::RowVectorXd scale = terms.colwise().norm();
    if (!(scale.minCoeff() > 0)) return {};
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr;
    qr.setThreshold(1e-2);
    qr.compute(terms * scale.cwiseInverse().asDiagonal());
    if (qr.rank() < unknowns) return {};
    const Eigen::VectorXd solved = qr.solve(heights).cwiseQuotient(scale.transpose());
    const Vec3 normal = (up - solved[0] * x_axis - solved[1] * y_axis).normalized();
    if (!(normal.dot(up) > least_normal_agreement)) return {};
    return normal;
}

}  // namespace

Points3 corner_normals(const TriangleMesh& mesh, const Adjacency& adjacency,
                       const std::vector<std::array<int, 2>>& creases) {
    const std::set<std::array<int, 2>> sharp(creases.begin(), creases.end());
    std::vector<bool> crease(static_cast<std::size_t>(adjacency.half_edge_count()), false);
    for (int h = 0; h < adjacency.half_edge_count(); ++h)
        crease[at(h)] = sharp.contains({adjacency.from(h), adjacency.to(h)}) ||
                        sharp.contains({adjacency.to(h), adjacency.from(h)});
    Points3 normals = Points3::Zero(3 * mesh.triangle_count(), 3);
    Surroundings about(mesh, adjacency, crease);
    for (int corner = 0; corner < adjacency.half_edge_count(); ++corner) {
        if (!normals.row(corner).isZero()) continue;
        const std::vector<int> fan = about.fan(corner);
        const std::vector<int> neighbours = about.neighbours(fan);
        const int vertex = adjacency.from(corner);
        Vec3 normal = mean_normal(mesh, fan);
        std::optional<Vec3> fitted = fitted_normal(mesh, vertex, neighbours, normal, 9);
        if (!fitted) fitted = fitted_normal(mesh, vertex, neighbours, normal, 5);
        if (fitted) normal = *fitted;
        for (const int h : fan) normals.row(h) = normal;
    }
    return normals;
}

}  // namespace ripstop
