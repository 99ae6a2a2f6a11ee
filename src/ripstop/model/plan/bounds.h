#pragma once

#include "ripstop/geometry/types.h"

namespace ripstop {

/// Bounds on every flattening of a tile, computed from its shape before any flattening.
struct Bounds {
    /// The isoperimetric ratio L^2 / (4 pi A): below 1 no outline of length L encloses the area A. With tolerances a
    /// on the area and b on the length, a tile is impossible if (1 + b)^2 L^2 < 4 pi (1 - a) A.
    double isoperimetric = 0;

    /// A lower bound on the ratio of the largest to the smallest principal stretch. The tile contains a geodesic disc
    /// of radius rho with perimeter l. A map with stretches in [s1, s2] takes it to a region that contains a disc of
    /// radius s1 rho and has an outline of at most s2 l, so s2 / s1 >= 2 pi rho / l (after Milnor 1969: on a sphere,
    /// s / sin s). 1 if the tile has no positive curvature.
    double stretch_ratio = 1;
    Vec3 centre = Vec3::Zero();  ///< centre of that disc [m]
    double radius = 0;           ///< rho [m]
};

}  // namespace ripstop
