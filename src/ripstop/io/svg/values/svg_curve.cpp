#include "ripstop/io/svg/values/svg_curve.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ripstop {
namespace {

constexpr double most_chords = 4096;
constexpr double pi = std::numbers::pi;

int chords(double wanted) {
    return wanted > 1 ? static_cast<int>(std::ceil(std::min(wanted, most_chords))) : 1;
}

double allowed(const SvgSampling& sampling, double size) {
    return std::min(sampling.distance, sampling.share * size);
}

void sample_cubic(const Vec2& from, const Vec2& a, const Vec2& b, const Vec2& to, const SvgSampling& sampling,
                  std::vector<Vec2>& points) {
    const Vec2 lower = from.cwiseMin(a).cwiseMin(b).cwiseMin(to), upper = from.cwiseMax(a).cwiseMax(b).cwiseMax(to);
    const double bend = std::max((from - 2 * a + b).norm(), (a - 2 * b + to).norm());
    const double error = allowed(sampling, (upper - lower).maxCoeff());
    const int count = bend > 0 && error > 0 ? chords(std::sqrt(0.75 * bend / error)) : 1;
    for (int i = 1; i < count; ++i) {
        const double t = static_cast<double>(i) / count, s = 1 - t;
        points.emplace_back(s * s * s * from + 3 * s * s * t * a + 3 * s * t * t * b + t * t * t * to);
    }
    points.push_back(to);
}

/// The longer radius of the ellipse that `axes` maps the unit circle to.
double longer_radius(const Mat22& axes) {
    const double a = axes.squaredNorm(), b = axes.determinant();
    return std::sqrt((a + std::sqrt(std::max(0.0, a * a - 4 * b * b))) / 2);
}

void sample_arc(const SvgSegment& arc, const Eigen::Affine2d& motion, const SvgSampling& sampling,
                std::vector<Vec2>& points) {
    const Vec2 centre = motion * arc.centre;
    const Mat22 axes = motion.linear() * arc.axes;
    const double radius = longer_radius(axes), error = allowed(sampling, radius);
    const double step = error > 0 ? 2 * std::acos(std::max(0.0, 1 - error / radius)) : pi;
    int count = chords(std::abs(arc.sweep) / step);
    // A whole ellipse gets a multiple of four chords, so that an upright one keeps its width and height.
    if (std::abs(arc.sweep) >= 2 * pi) count = (count + 3) / 4 * 4;
    for (int i = 1; i < count; ++i) {
        const double t = arc.start_angle + arc.sweep * i / count;
        points.emplace_back(centre + axes * Vec2(std::cos(t), std::sin(t)));
    }
    points.emplace_back(motion * arc.to);
}

double angle_between(const Vec2& a, const Vec2& b) {
    return std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
}

}  // namespace

SvgSegment svg_line(const Vec2& to) {
    SvgSegment segment;
    segment.to = to;
    return segment;
}

SvgSegment svg_cubic(const Vec2& first_control, const Vec2& second_control, const Vec2& to) {
    SvgSegment segment;
    segment.kind = SvgSegment::Kind::cubic;
    segment.first_control = first_control;
    segment.second_control = second_control;
    segment.to = to;
    return segment;
}

SvgSegment svg_arc(const Vec2& from, const Vec2& radii, double turn, bool is_large, bool is_positive, const Vec2& to) {
    SvgSegment arc = svg_line(to);
    Vec2 r = radii.cwiseAbs();
    if (r.minCoeff() <= 0 || from == to) return arc;
    const Mat22 turned = Eigen::Rotation2Dd(turn).toRotationMatrix();
    const Vec2 half = turned.transpose() * (from - to) / 2;  // from the chord's middle to its start, in the axes
    const Vec2 unit = half.cwiseQuotient(r);
    const double reach = unit.squaredNorm();
    if (!std::isfinite(reach)) return arc;
    if (reach > 1) r *= std::sqrt(reach);
    const double off = reach > 1 || reach <= 0 ? 0 : std::sqrt(std::max(0.0, 1 / reach - 1));
    const double side = is_large == is_positive ? -1 : 1;
    const Vec2 centre(side * off * r.x() * half.y() / r.y(), -side * off * r.y() * half.x() / r.x());
    const Vec2 begin = (half - centre).cwiseQuotient(r), end = (-half - centre).cwiseQuotient(r);
    arc.sweep = angle_between(begin, end);
    if (is_positive && arc.sweep <= 0) arc.sweep += 2 * pi;
    if (!is_positive && arc.sweep >= 0) arc.sweep -= 2 * pi;
    arc.kind = SvgSegment::Kind::arc;
    arc.centre = turned * centre + (from + to) / 2;
    arc.axes = turned * r.asDiagonal();
    arc.start_angle = std::atan2(begin.y(), begin.x());
    return arc;
}

SvgRun svg_ellipse(const Vec2& centre, const Vec2& radii) {
    SvgSegment round;
    round.kind = SvgSegment::Kind::arc;
    round.to = centre + Vec2(radii.x(), 0);
    round.centre = centre;
    round.axes = radii.asDiagonal();
    round.sweep = 2 * pi;
    return {round.to, {round}, true};
}

SvgRun svg_rectangle(const Vec2& corner, const Vec2& size, const Vec2& radii) {
    const Vec2 far = corner + size;
    if (radii.minCoeff() <= 0)
        return {corner, {svg_line({far.x(), corner.y()}), svg_line(far), svg_line({corner.x(), far.y()})}, true};
    const Vec2 r = radii.cwiseMin(size / 2);
    SvgRun run{corner + Vec2(r.x(), 0), {}, true};
    Vec2 here = run.start;
    const auto side = [&](const Vec2& to) {
        if (to != here) run.segments.push_back(svg_line(to));
        here = to;
    };
    const auto round = [&](const Vec2& to) {
        run.segments.push_back(svg_arc(here, r, 0, false, true, to));
        here = to;
    };
    side({far.x() - r.x(), corner.y()});
    round({far.x(), corner.y() + r.y()});
    side({far.x(), far.y() - r.y()});
    round({far.x() - r.x(), far.y()});
    side({corner.x() + r.x(), far.y()});
    round({corner.x(), far.y() - r.y()});
    side({corner.x(), corner.y() + r.y()});
    round(run.start);
    return run;
}

std::vector<Vec2> sampled(const SvgRun& run, const Eigen::Affine2d& motion, const SvgSampling& sampling) {
    std::vector<Vec2> points{motion * run.start};
    for (const SvgSegment& segment : run.segments) {
        if (segment.kind == SvgSegment::Kind::line)
            points.emplace_back(motion * segment.to);
        else if (segment.kind == SvgSegment::Kind::cubic)
            sample_cubic(Vec2(points.back()), motion * segment.first_control, motion * segment.second_control,
                         motion * segment.to, sampling, points);
        else
            sample_arc(segment, motion, sampling, points);
    }
    return points;
}

}  // namespace ripstop
