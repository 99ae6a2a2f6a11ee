#include "ripstop/remesh/smooth_surface.h"

#include <set>

#include "ripstop/remesh/corner_normals.h"

namespace ripstop {

SmoothSurface::SmoothSurface(const TriangleMesh& mesh, const Adjacency& adjacency, const std::vector<int>& boundary,
                             const std::vector<std::array<int, 2>>& creases, const BoundarySlopes& slopes)
    : mesh_(&mesh), controls_(7 * mesh.triangle_count(), 3) {
    const Points3 normals = corner_normals(mesh, adjacency, creases);
    const std::set<std::array<int, 2>> sharp(creases.begin(), creases.end());
    std::vector<Eigen::Index> place(static_cast<std::size_t>(mesh.vertex_count()), -1);
    for (std::size_t i = 0; i < boundary.size(); ++i)
        place[static_cast<std::size_t>(boundary[i])] = static_cast<Eigen::Index>(i);
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        Vec3 sum = Vec3::Zero(), corners = Vec3::Zero();
        for (int k = 0; k < 3; ++k) {
            const int h = 3 * t + k, i = adjacency.from(h), j = adjacency.to(h);
            const Vec3 p = mesh.positions.row(i), q = mesh.positions.row(j);
            Vec3 first, second;  // the control points b_ij and b_ji
            if (adjacency.is_boundary(h)) {
                const Eigen::Index e = place[static_cast<std::size_t>(i)];
                first = p + Vec3(slopes.start.row(e)) / 3;
                second = q - Vec3(slopes.end.row(e)) / 3;
            } else if (sharp.contains({i, j}) || sharp.contains({j, i})) {
                first = (2 * p + q) / 3;
                second = (2 * q + p) / 3;
            } else {
                const Vec3 at_p = normals.row(h), at_q = normals.row(Adjacency::next(h));
                first = (2 * p + q - (q - p).dot(at_p) * at_p) / 3;
                second = (2 * q + p - (p - q).dot(at_q) * at_q) / 3;
            }
            controls_.row(7 * t + 2 * k) = first;
            controls_.row(7 * t + 2 * k + 1) = second;
            sum += first + second;
            corners += p;
        }
        controls_.row(7 * t + 6) = sum / 6 + (sum / 6 - corners / 3) / 2;
    }
}

Vec3 SmoothSurface::at(const MeshPlace& place) const {
    const double u = place.weights[0], v = place.weights[1], w = place.weights[2];
    const Eigen::Index t = place.triangle, first = 7 * t;
    const auto b = [&](int k) { return Vec3(controls_.row(first + k)); };
    const auto p = [&](int k) { return mesh_->corner(place.triangle, k); };
    return p(0) * (u * u * u) + p(1) * (v * v * v) + p(2) * (w * w * w) + b(0) * (3 * u * u * v) +
           b(1) * (3 * u * v * v) + b(2) * (3 * v * v * w) + b(3) * (3 * v * w * w) + b(4) * (3 * w * w * u) +
           b(5) * (3 * w * u * u) + b(6) * (6 * u * v * w);
}

}  // namespace ripstop
