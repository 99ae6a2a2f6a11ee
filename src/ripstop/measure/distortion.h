#pragma once

#include <vector>

#include "ripstop/mesh/triangle_mesh.h"

namespace ripstop {

/// What one triangle of cloth goes through on its way into space: the map flat -> surface, F (2 x 2, in the plane of
/// the triangle in space), and what follows from it.
struct TriangleDistortion {
    double stretch_max = 1,
           stretch_min = 1;  ///< singular values of F, cloth -> space; infinite where the cloth has no area
    double warp_strain = 0, weft_strain = 0;  ///< |F e_x| - 1, |F e_y| - 1: positive where the cloth must stretch
    double shear = 0;                         ///< pi/2 less the angle between F e_x and F e_y [rad], signed
    double area_ratio = 1;  ///< area on the cloth over area on the surface, negative where turned over
    bool flipped = false;   ///< turned over, or without area on the cloth
};

/// The distortion of every triangle (#F) of flat positions (#V x 2, +x the warp). Any mesh, disk or not.
std::vector<TriangleDistortion> measure_distortion(const TriangleMesh& mesh, const Points2& flat);

/// The same against what each triangle of cloth is to be (#F, `target_triangles`).
std::vector<TriangleDistortion> measure_distortion(const std::vector<Mat22>& targets, const Triangles& triangles,
                                                   const Points2& flat);

}  // namespace ripstop
