#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "ripstop/geometry/types.h"

namespace ripstop {

/// A part of an outline, from where the part before it ends.
struct SvgSegment {
    enum class Kind { line, cubic, arc };
    Kind kind = Kind::line;
    Vec2 to = Vec2::Zero();
    Vec2 first_control = Vec2::Zero(), second_control = Vec2::Zero();  ///< of a cubic Bézier curve
    Vec2 centre = Vec2::Zero();  ///< of an arc, whose points are centre + axes (cos t, sin t)
    Mat22 axes = Mat22::Zero();
    double start_angle = 0, sweep = 0;  ///< t goes from the one by the other [rad]
};

/// Segments from end to end: what a path draws from M to the next M, or to Z.
struct SvgRun {
    Vec2 start = Vec2::Zero();
    std::vector<SvgSegment> segments = {};
    bool is_closed = false;
};

SvgSegment svg_line(const Vec2& to);
SvgSegment svg_cubic(const Vec2& first_control, const Vec2& second_control, const Vec2& to);

/// The arc of a path: an ellipse of two radii, turned by `turn` [rad], through both ends. By the rules of SVG 2,
/// appendix B.2: radii that are too small grow together until the ellipse reaches, a radius of 0 is a straight line.
SvgSegment svg_arc(const Vec2& from, const Vec2& radii, double turn, bool is_large, bool is_positive, const Vec2& to);

/// The whole ellipse from its rightmost point. Radii above 0.
SvgRun svg_ellipse(const Vec2& centre, const Vec2& radii);

/// From the upper left corner on in the order of SVG; corners rounded by `radii`, each at most half of its side.
SvgRun svg_rectangle(const Vec2& corner, const Vec2& size, const Vec2& radii);

/// How near the chords come to a curve: within `distance` (in the moved coordinates), and within `share` of the size of
/// the curve's control polygon or the ellipse's longer radius, whichever is less.
struct SvgSampling {
    double distance = 0.05, share = 1e-3;
};

/// The points of a run after `motion`, whose first one is its start; the last one of a closed run may be the same. A
/// cubic is divided equally in its parameter by L.-N. Wang's bound, n = sqrt(6/8 max|second difference| / error); an
/// arc so that its sagitta, longer radius (1 - cos(h/2)), is the error. At most 4096 chords a segment.
std::vector<Vec2> sampled(const SvgRun& run, const Eigen::Affine2d& motion, const SvgSampling& sampling);

}  // namespace ripstop
