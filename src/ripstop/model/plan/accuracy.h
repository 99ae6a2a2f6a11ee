#pragma once

#include <vector>

#include "ripstop/geometry/types.h"

namespace ripstop {

/// The accuracy of one chain of a flattened tile; lengths [m].
struct ChainAccuracy {
    double length = 0;
    double flat_length = 0;
    double error() const { return flat_length / length - 1; }  ///< signed
};

/// The accuracy of a flattening: lengths [m], areas [m2], errors as ratios (0.001 is 1 mm per metre). In the formulas
/// L' and A' are on the cloth, L and A on the surface. Sources: [KZ] the paper, [WSY02] Wang, Smith, Yuen 2002.
struct Accuracy {
    double area = 0;
    double flat_area = 0;
    double area_error = 0;      ///< sum A' / sum A - 1 [KZ]
    double area_error_abs = 0;  ///< sum |A' - A| / sum A, E_S of [WSY02, eq. 4]
    double perimeter = 0;
    double flat_perimeter = 0;
    double perimeter_error = 0;     ///< sum L' / sum L - 1 over the boundary [KZ]
    double edge_error_abs = 0;      ///< sum |L' - L| / sum L over all edges, E_C of [WSY02, eq. 6]
    double boundary_error_abs = 0;  ///< the same over boundary edges
    double boundary_error_max = 0;  ///< worst boundary edge, |L'/L - 1|
    std::vector<ChainAccuracy> chains;

    /// Strain of the map cloth -> space, positive where the cloth must stretch: minimum and maximum over the
    /// triangles.
    double warp_strain_min = 0, warp_strain_max = 0;
    double weft_strain_min = 0, weft_strain_max = 0;
    double shear_max = 0;  ///< largest change of the right angle between warp and weft [rad]
    double energy = 0;     ///< elastic energy of the woven membrane, cloth -> surface [J]; infinite if a triangle is
                           ///< flipped

    int flipped = 0;            ///< triangles that are flipped or have no area on the cloth
    int overlaps = 0;           ///< pairs of triangles that overlap on the cloth
    int outline_crossings = 0;  ///< places where the flat outline crosses or touches itself

    /// The places of the worst values, on the surface.
    Vec3 worst_edge = Vec3::Zero();  ///< midpoint of the worst boundary edge
    Vec3 worst_warp = Vec3::Zero();  ///< centroid of the triangle with the largest |warp strain|
    Vec3 worst_weft = Vec3::Zero();
    Vec3 worst_shear = Vec3::Zero();
    Vec3 worst_flip = Vec3::Zero();  ///< centroid of the first flipped triangle
    Vec3 worst_overlap = Vec3::Zero();
};

}  // namespace ripstop
