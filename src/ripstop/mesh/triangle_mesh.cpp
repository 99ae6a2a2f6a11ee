#include "ripstop/mesh/triangle_mesh.h"

#include <Eigen/Geometry>

#include "ripstop/geometry/triangle.h"

namespace ripstop {

double triangle_area(const TriangleMesh& mesh, int triangle) {
    return triangle_area(mesh.corner(triangle, 0), mesh.corner(triangle, 1), mesh.corner(triangle, 2));
}

Eigen::VectorXd triangle_areas(const TriangleMesh& mesh) {
    Eigen::VectorXd areas(mesh.triangle_count());
    for (int t = 0; t < mesh.triangle_count(); ++t) areas[t] = triangle_area(mesh, t);
    return areas;
}

double surface_area(const TriangleMesh& mesh) {
    return triangle_areas(mesh).sum();
}

Vec3 area_vector(const TriangleMesh& mesh, int triangle) {
    const Vec3 a = mesh.corner(triangle, 0);
    return 0.5 * (mesh.corner(triangle, 1) - a).cross(mesh.corner(triangle, 2) - a);
}

Vec3 area_vector(const TriangleMesh& mesh) {
    Vec3 sum = Vec3::Zero();
    for (int t = 0; t < mesh.triangle_count(); ++t) sum += area_vector(mesh, t);
    return sum;
}

Eigen::AlignedBox3d box_of(const TriangleMesh& mesh) {
    Eigen::AlignedBox3d box;
    for (Eigen::Index v = 0; v < mesh.positions.rows(); ++v) box.extend(Vec3(mesh.positions.row(v)));
    return box;
}

Vec3 centroid(const TriangleMesh& mesh) {
    Vec3 sum = Vec3::Zero();
    double total = 0;
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        const double area = triangle_area(mesh, t);
        sum += area / 3 * (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2));
        total += area;
    }
    if (total > 0) return sum / total;
    return mesh.vertex_count() ? Vec3(mesh.positions.colwise().mean()) : Vec3(Vec3::Zero());
}

double bounding_diagonal(const TriangleMesh& mesh) {
    if (mesh.vertex_count() == 0) return 0;
    return (mesh.positions.colwise().maxCoeff() - mesh.positions.colwise().minCoeff()).norm();
}

}  // namespace ripstop
