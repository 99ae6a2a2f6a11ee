#include "ripstop/measure/distortion.h"

#include <Eigen/LU>
#include <cmath>
#include <limits>

#include "ripstop/energy/deformation.h"
#include "ripstop/geometry/triangle.h"

namespace ripstop {
namespace {

TriangleDistortion distortion(const Mat22& surface, const Mat22& cloth) {
    TriangleDistortion result;
    const double flat_area = cloth.determinant();
    result.area_ratio = flat_area / surface.determinant();
    result.flipped = !(result.area_ratio > 0);
    const ThreadStrain strain = thread_strain(triangle_metric(surface), cloth);
    result.warp_strain = strain.warp;
    result.weft_strain = strain.weft;
    result.shear = strain.shear;
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
    return result;
}

}  // namespace

std::vector<TriangleDistortion> measure_distortion(const std::vector<Mat22>& targets, const Triangles& triangles,
                                                   const Points2& flat) {
    std::vector<TriangleDistortion> result;
    result.reserve(targets.size());
    for (std::size_t t = 0; t < targets.size(); ++t)
        result.push_back(distortion(targets[t], flat_edges(triangles, flat, static_cast<int>(t))));
    return result;
}

std::vector<TriangleDistortion> measure_distortion(const TriangleMesh& mesh, const Points2& flat) {
    std::vector<Mat22> surface;
    for (int t = 0; t < mesh.triangle_count(); ++t)
        surface.push_back(lay_flat(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)));
    return measure_distortion(surface, mesh.triangles, flat);
}

}  // namespace ripstop
