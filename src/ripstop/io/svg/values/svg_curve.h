#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "ripstop/geometry/types.h"

namespace ripstop {

/// A segment of an outline. It starts where the segment before it ends.
struct SvgSegment {
    enum class Kind { line, cubic, arc };
    Kind kind = Kind::line;
    Vec2 to = Vec2::Zero();
    Vec2 first_control = Vec2::Zero(), second_control = Vec2::Zero();  ///< of a cubic Bézier curve
    Vec2 centre = Vec2::Zero();  ///< of an arc; its points are centre + axes (cos t, sin t)
    Mat22 axes = Mat22::Zero();
    double start_angle = 0, sweep = 0;  ///< of an arc: t runs from start_angle over sweep [rad]
};

/// Connected segments: what a path draws from M to the next M, or to Z.
struct SvgRun {
    Vec2 start = Vec2::Zero();
    std::vector<SvgSegment> segments = {};
    bool is_closed = false;
};

SvgSegment svg_line(const Vec2& to);
SvgSegment svg_cubic(const Vec2& first_control, const Vec2& second_control, const Vec2& to);

/// The elliptical arc of a path: both radii, turned by `turn` [rad], through both ends. Follows SVG 2, appendix
/// B.2: radii that are too small grow together until the ellipse reaches both ends; a radius of 0 gives a straight
/// line.
SvgSegment svg_arc(const Vec2& from, const Vec2& radii, double turn, bool is_large, bool is_positive, const Vec2& to);

/// The whole ellipse from its rightmost point. Radii must be positive.
SvgRun svg_ellipse(const Vec2& centre, const Vec2& radii);

/// A rectangle from its upper left corner, in the order of SVG. `radii` round the corners, each at most half of
/// its side.
SvgRun svg_rectangle(const Vec2& corner, const Vec2& size, const Vec2& radii);

/// How close the chords stay to a curve: within `distance` (in the moved coordinates), and within `share` of the
/// size of the curve's control polygon or of the ellipse's longer radius, whichever is less.
struct SvgSampling {
    double distance = 0.05, share = 1e-3;
};

/// The points of a run after `motion`, from its start; the last point of a closed run may equal the first. A cubic
/// is divided equally in its parameter by L.-N. Wang's bound, n = sqrt(6/8 max|second difference| / error). An arc
/// is divided so that its sagitta, longer radius (1 - cos(h/2)), equals the error. A segment has at most 4096
/// chords.
std::vector<Vec2> sampled(const SvgRun& run, const Eigen::Affine2d& motion, const SvgSampling& sampling);

}  // namespace ripstop
