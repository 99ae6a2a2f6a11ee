#pragma once

#include "ripstop/geometry/types.h"

namespace ripstop {

/// A rigid motion of one outline onto another, and how well it then covers it.
struct OutlineFit {
    double turn = 0;           ///< of the first before it is moved onto the second [rad]
    Vec2 from = Vec2::Zero();  ///< about this point of the first,
    Vec2 to = Vec2::Zero();    ///< which comes here
    double root_mean_square = 0;
    double distance = 0;  ///< the largest, of either outline's points from the other [m]

    /// Points of the first, where the motion takes them (#P x 2).
    Points2 moved(const Points2& points) const;
};

/// The rigid motion (no mirroring) of outline `a` onto `b` of least mean squared distance: iterated closest points
/// [BM92] between 200 points spaced evenly along `a` and the outline `b`, from where they lie with the centroids
/// together, and from principal axis on principal axis either way; a turned fit counts only where it is better by a
/// tenth.
OutlineFit fit_outline(const Points2& a, const Points2& b);

/// Largest distance of the points of either outline, corners and 200 between, from the other [m].
double outline_distance(const Points2& a, const Points2& b);

/// The same of two lines that are not closed, of at least two points each; between corners, seven points.
double line_distance(const Points2& a, const Points2& b);

}  // namespace ripstop
