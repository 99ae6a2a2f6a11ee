#include "ripstop/measure/distortion.h"

#include <Eigen/LU>
#include <cmath>
#include <limits>

#include "ripstop/geometry/triangle.h"

namespace ripstop {
namespace {

TriangleDistortion distortion(const Mat22& surface, const Mat22& cloth) {
    TriangleDistortion result;
    const double flat_area = cloth.determinant();
    result.area_ratio = flat_area / surface.determinant();
    result.flipped = !(result.area_ratio > 0);
    if (flat_area == 0) {
        result.stretch_max = result.stretch_min = std::numeric_limits<double>::infinity();
        return result;
    }
    const Mat22 F = surface * cloth.inverse();
    // singular values of a 2 x 2 matrix from its conformal and anticonformal parts
    const double conformal = 0.5 * std::hypot(F(0, 0) + F(1, 1), F(1, 0) - F(0, 1));
    const double anticonformal = 0.5 * std::hypot(F(0, 0) - F(1, 1), F(1, 0) + F(0, 1));
    result.stretch_max = conformal + anticonformal;
    result.stretch_min = std::abs(conformal - anticonformal);
    const Vec2 warp = F.col(0);
    const Vec2 weft = F.col(1);
    result.warp_strain = warp.norm() - 1;
    result.weft_strain = weft.norm() - 1;
    result.shear = std::atan2(warp.dot(weft), std::abs(cross(warp, weft)));
    return result;
}

}  // namespace

std::vector<TriangleDistortion> measure_distortion(const TriangleMesh& mesh, const Points2& flat) {
    std::vector<TriangleDistortion> result;
    result.reserve(static_cast<std::size_t>(mesh.triangle_count()));
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        const Vec2 a = flat.row(mesh.triangles(t, 0));
        Mat22 cloth;
        cloth.col(0) = Vec2(flat.row(mesh.triangles(t, 1))) - a;
        cloth.col(1) = Vec2(flat.row(mesh.triangles(t, 2))) - a;
        result.push_back(distortion(lay_flat(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)), cloth));
    }
    return result;
}

}  // namespace ripstop
