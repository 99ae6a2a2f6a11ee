#include "ripstop/pattern/revision/fit_outline.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "ripstop/geometry/polygon.h"
#include "ripstop/geometry/triangle.h"

namespace ripstop {
namespace {

constexpr int outline_samples = 200;
constexpr int most_steps = 100;

Points2 evenly_spaced(const Points2& outline) {
    const double spacing = perimeter(outline) / outline_samples;
    Points2 points(outline_samples, 2);
    double left = 0;
    int next = 0;
    for (Eigen::Index i = 0; i < outline.rows() && next < outline_samples; ++i) {
        const Vec2 from = outline.row(i), to = outline.row((i + 1) % outline.rows());
        const double length = (to - from).norm();
        for (; left <= length && next < outline_samples && length > 0; left += spacing)
            points.row(next++) = (from + left / length * (to - from)).transpose();
        left -= length;
    }
    for (; next < outline_samples; ++next) points.row(next) = outline.row(0);  // against rounding of the last samples
    return points;
}

Vec2 nearest_on_side(const Vec2& from, const Vec2& to, const Vec2& point) {
    const Vec2 way = to - from;
    const double square = way.squaredNorm();
    const double along = square > 0 ? std::clamp((point - from).dot(way) / square, 0.0, 1.0) : 0.0;
    return from + along * way;
}

Vec2 nearest_on(const Points2& outline, const Vec2& point) {
    Vec2 best = outline.row(0);
    for (Eigen::Index i = 0; i < outline.rows(); ++i) {
        const Vec2 at = nearest_on_side(outline.row(i), outline.row((i + 1) % outline.rows()), point);
        if ((at - point).squaredNorm() < (best - point).squaredNorm()) best = at;
    }
    return best;
}

double furthest(const Points2& points, const Points2& outline) {
    double most = 0;
    for (Eigen::Index i = 0; i < points.rows(); ++i) most = std::max(most, distance_to_outline(outline, points.row(i)));
    return most;
}

/// The largest distance of points on one line, its corners and some between, from the other.
double furthest_off(const Points2& line, const Points2& other) {
    constexpr int steps = 8;
    double most = 0;
    for (Eigen::Index i = 0; i + 1 < line.rows(); ++i)
        for (int step = 0; step <= steps; ++step) {
            const Vec2 point = line.row(i) + (line.row(i + 1) - line.row(i)) * (double(step) / steps);
            double least = std::numeric_limits<double>::infinity();
            for (Eigen::Index k = 0; k + 1 < other.rows(); ++k)
                least = std::min(least, (nearest_on_side(other.row(k), other.row(k + 1), point) - point).norm());
            most = std::max(most, least);
        }
    return most;
}

/// The principal axis of points.
double principal_axis(const Points2& points) {
    const Points2 centred = points.rowwise() - points.colwise().mean();
    const Mat22 spread = centred.transpose() * centred;
    return 0.5 * std::atan2(2 * spread(0, 1), spread(0, 0) - spread(1, 1));
}

OutlineFit fit_from(const Points2& a, const Points2& b, double turn) {
    const Points2 points = evenly_spaced(a);
    const Vec2 centre = points.colwise().mean();
    Vec2 place = evenly_spaced(b).colwise().mean();
    double square = 0;
    for (int step = 0; step < most_steps; ++step) {
        const Points2 at = OutlineFit{turn, centre, place}.moved(points);
        Points2 nearest(outline_samples, 2);
        for (Eigen::Index i = 0; i < outline_samples; ++i) nearest.row(i) = nearest_on(b, at.row(i)).transpose();
        const Vec2 goal = nearest.colwise().mean();
        double sine = 0, cosine = 0;
        square = 0;
        for (Eigen::Index i = 0; i < outline_samples; ++i) {
            const Vec2 from = Vec2(at.row(i)) - place, to = Vec2(nearest.row(i)) - goal;
            sine += cross(from, to);
            cosine += from.dot(to);
            square += (at.row(i) - nearest.row(i)).squaredNorm();
        }
        const double more = std::atan2(sine, cosine);
        turn += more;
        const double shifted = (goal - place).norm();
        place = goal;
        if (std::abs(more) < 1e-12 && shifted < 1e-12) break;
    }
    OutlineFit fit{std::remainder(turn, 2 * std::numbers::pi), centre, place, std::sqrt(square / outline_samples)};
    fit.distance = outline_distance(fit.moved(a), b);
    return fit;
}

}  // namespace

Points2 OutlineFit::moved(const Points2& points) const {
    const double cosine = std::cos(turn), sine = std::sin(turn);
    const Mat22 rotation{{cosine, -sine}, {sine, cosine}};
    Points2 result(points.rows(), 2);
    for (Eigen::Index i = 0; i < points.rows(); ++i)
        result.row(i) = (rotation * (Vec2(points.row(i)) - from) + to).transpose();
    return result;
}

double outline_distance(const Points2& a, const Points2& b) {
    return std::max({furthest(a, b), furthest(b, a), furthest(evenly_spaced(a), b), furthest(evenly_spaced(b), a)});
}

OutlineFit fit_outline(const Points2& a, const Points2& b) {
    OutlineFit best = fit_from(a, b, 0);
    const double between = principal_axis(evenly_spaced(b)) - principal_axis(evenly_spaced(a));
    for (const double turn : {between, between + std::numbers::pi}) {
        const OutlineFit fit = fit_from(a, b, turn);
        if (fit.root_mean_square < 0.9 * best.root_mean_square - 1e-12) best = fit;
    }
    return best;
}

double line_distance(const Points2& a, const Points2& b) {
    return std::max(furthest_off(a, b), furthest_off(b, a));
}

}  // namespace ripstop
