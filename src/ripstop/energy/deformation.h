#pragma once

#include <vector>

#include "ripstop/mesh/triangle_mesh.h"

namespace ripstop {

/// The metric of a surface triangle: the Gram matrix Bᵀ B of its edges b - a and c - a [m2]. It depends on lengths
/// only, not on the position in space.
struct TriangleMetric {
    double aa = 0;  ///< |b - a|2
    double ab = 0;  ///< (b - a) · (c - a)
    double bb = 0;  ///< |c - a|2
};

/// The metric of a triangle in space.
TriangleMetric triangle_metric(const Vec3& a, const Vec3& b, const Vec3& c);
TriangleMetric triangle_metric(const Mat22& edges);  ///< of a triangle given by its edges b - a and c - a in the plane

/// The edges of a triangle on the cloth: columns b - a and c - a [m]. det > 0 if its outside face is up.
Mat22 flat_edges(const Triangles& triangles, const Points2& positions, int triangle);

/// The right Cauchy-Green tensor in the axes of the cloth (x the warp, y the weft): C = D⁻ᵀ G D⁻¹ = Fᵀ F, where F is
/// the map cloth -> space, G the metric and D the flat edges. It is the identity for an isometry. Requires det D !=
/// 0.
Mat22 cauchy_green(const TriangleMetric& metric, const Mat22& flat);

/// The strain of warp and weft and the shear between them, from cloth to space.
struct ThreadStrain {
    double warp = 0;   ///< |F e_x| - 1
    double weft = 0;   ///< |F e_y| - 1
    double shear = 0;  ///< asin of the cosine between warp and weft [rad]; positive where the warp turns towards the
                       ///< weft
};

/// Returns infinite strain and a shear of pi / 2 if the flat triangle has no area.
ThreadStrain thread_strain(const TriangleMetric& metric, const Mat22& flat);

}  // namespace ripstop
