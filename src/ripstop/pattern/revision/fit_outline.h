#pragma once

#include "ripstop/geometry/types.h"

namespace ripstop {

/// A rigid motion of one outline onto another, and the quality of the fit.
struct OutlineFit {
    double turn = 0;           ///< rotation of the first outline [rad],
    Vec2 from = Vec2::Zero();  ///< about this point of it,
    Vec2 to = Vec2::Zero();    ///< which moves here
    double root_mean_square = 0;
    double distance = 0;  ///< largest distance of either outline's points from the other [m]

    /// Points of the first outline after the motion (#P x 2).
    Points2 moved(const Points2& points) const;
};

/// The rigid motion (without mirroring) of outline `a` onto `b` with least mean squared distance, by iterated
/// closest points [BM92] from 200 evenly spaced points of `a` to outline `b`. Starts with coinciding centroids,
/// unrotated and with aligned principal axes, both ways. A rotated fit is chosen only if it is better by a tenth.
OutlineFit fit_outline(const Points2& a, const Points2& b);

/// The largest distance of points of either outline (corners and 200 others) from the other [m].
double outline_distance(const Points2& a, const Points2& b);

/// The largest distance of points of either open line from the other [m]. Lines have at least two points; seven
/// points between neighbouring corners are tested too.
double line_distance(const Points2& a, const Points2& b);

}  // namespace ripstop
