#pragma once

#include <vector>

#include "ripstop/mesh/triangle_mesh.h"

namespace ripstop {

/// The deformation of one triangle from the cloth to the surface: derived from the map F (2 x 2, in the plane of the
/// triangle in space).
struct TriangleDistortion {
    double stretch_max = 1,
           stretch_min = 1;  ///< singular values of F, cloth -> space; infinite if the flat triangle has no area
    double warp_strain = 0, weft_strain = 0;  ///< |F e_x| - 1, |F e_y| - 1: positive where the cloth must stretch
    double shear = 0;                         ///< pi/2 minus the angle between F e_x and F e_y [rad], signed
    double area_ratio = 1;                    ///< area on the cloth over area on the surface, negative if flipped
    bool flipped = false;                     ///< flipped, or without area on the cloth
};

/// The distortion of every triangle (#F) of flat positions (#V x 2, +x the warp). The mesh need not be a disk.
std::vector<TriangleDistortion> measure_distortion(const TriangleMesh& mesh, const Points2& flat);

/// The same relative to the target shape of each triangle (#F, `target_triangles`).
std::vector<TriangleDistortion> measure_distortion(const std::vector<Mat22>& targets, const Triangles& triangles,
                                                   const Points2& flat);

}  // namespace ripstop
