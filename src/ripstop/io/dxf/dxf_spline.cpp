#include <algorithm>
#include <cmath>

#include "ripstop/io/dxf/dxf_shapes.h"

namespace ripstop {
namespace {

using Vec4 = Eigen::Vector4d;

constexpr int highest_degree = 25, deepest_halving = 10;
constexpr std::size_t most_spline_points = 200000;

/// A B-spline in homogeneous coordinates (w x, w y, w z, w).
struct Spline {
    int degree = 3;
    std::vector<double> knots;
    std::vector<Vec4> controls;
    bool is_closed = false;

    bool is_whole() const {
        const std::size_t n = controls.size(), p = static_cast<std::size_t>(degree);
        return degree >= 1 && degree <= highest_degree && n > p && knots.size() == n + p + 1 &&
               std::is_sorted(knots.begin(), knots.end()) && knots[p] < knots[n] &&
               std::all_of(controls.begin(), controls.end(), [](const Vec4& c) { return c.w() > 0 && c.allFinite(); });
    }

    /// Evaluates the curve by de Boor's algorithm between knots[span] and knots[span + 1].
    Vec3 at(double t, std::size_t span) const {
        const std::size_t p = static_cast<std::size_t>(degree);
        std::vector<Vec4> d(controls.begin() + static_cast<long>(span - p),
                            controls.begin() + static_cast<long>(span) + 1);
        for (std::size_t r = 1; r <= p; ++r)
            for (std::size_t j = p; j >= r; --j) {
                const double low = knots[j + span - p], high = knots[j + 1 + span - r];
                const double share = high > low ? (t - low) / (high - low) : 0;
                d[j] = (1 - share) * d[j - 1] + share * d[j];
            }
        return d[p].head<3>() / d[p].w();
    }
};

Spline spline_of(const DxfEntity& entity) {
    Spline spline;
    spline.degree = entity.flags(71);
    spline.is_closed = (entity.flags(70) & 1) != 0;
    std::vector<double> weights;
    for (const DxfTag& tag : entity.tags().subspan(1)) {
        // The axis of a HELIX has the same codes and follows here.
        if (tag.code == 100 && tag.value == "AcDbHelix") break;
        if (tag.code == 40) spline.knots.push_back(entity.number(tag));
        if (tag.code == 41) weights.push_back(entity.number(tag));
        if (tag.code == 10) spline.controls.emplace_back(entity.number(tag), 0, 0, 1);
        if (tag.code == 20 && !spline.controls.empty()) spline.controls.back().y() = entity.number(tag);
        if (tag.code == 30 && !spline.controls.empty()) spline.controls.back().z() = entity.number(tag);
    }
    if (weights.size() == spline.controls.size())
        for (std::size_t i = 0; i < weights.size(); ++i) spline.controls[i] *= weights[i];
    return spline;
}

void set_uniform_knots(Spline& spline) {
    const int p = spline.degree, n = static_cast<int>(spline.controls.size());
    for (int i = 0; i < n + p + 1; ++i) spline.knots.push_back(std::clamp(i - p, 0, n - p));
}

/// The C2 cubic spline through points, as one Bézier curve between neighbouring points. Solves the tridiagonal
/// equations of its derivatives, parameterized by chord length (de Boor, A Practical Guide to Splines, chapter
/// IV).
Spline spline_through(const std::vector<Vec3>& points, const Vec3& first_tangent, const Vec3& last_tangent) {
    const std::size_t n = points.size() - 1;
    std::vector<double> h(n), upper(n + 1, 0);
    for (std::size_t i = 0; i < n; ++i) h[i] = (points[i + 1] - points[i]).norm();
    std::vector<Vec3> slope(n + 1);
    slope[0] = first_tangent;
    slope[n] = last_tangent;
    for (std::size_t i = 1; i < n; ++i) {
        const Vec3 right =
            3 * ((points[i] - points[i - 1]) / (h[i - 1] * h[i - 1]) + (points[i + 1] - points[i]) / (h[i] * h[i]));
        const double pivot = 2 / h[i - 1] + 2 / h[i] - upper[i - 1] / h[i - 1];
        upper[i] = 1 / h[i] / pivot;
        slope[i] = (right - slope[i - 1] / h[i - 1]) / pivot;
    }
    for (std::size_t i = n; i-- > 1;) slope[i] -= upper[i] * slope[i + 1];
    Spline spline;
    const auto add = [&spline](const Vec3& at) { spline.controls.emplace_back(at.x(), at.y(), at.z(), 1); };
    spline.knots.assign(4, 0);
    add(points[0]);
    double length = 0;
    for (std::size_t i = 0; i < n; ++i) {
        add(points[i] + h[i] / 3 * slope[i]);
        add(points[i + 1] - h[i] / 3 * slope[i + 1]);
        add(points[i + 1]);
        spline.knots.insert(spline.knots.end(), 3, length += h[i]);
    }
    spline.knots.push_back(length);
    return spline;
}

/// The spline through the fit points; without control points if there is none.
Spline spline_of_fit_points(const DxfEntity& entity) {
    std::vector<Vec3> points;
    for (const DxfTag& tag : entity.tags().subspan(1)) {
        if (tag.code == 11) points.emplace_back(entity.number(tag), 0, 0);
        if (tag.code == 21 && !points.empty()) points.back().y() = entity.number(tag);
        if (tag.code == 31 && !points.empty()) points.back().z() = entity.number(tag);
    }
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (points.size() < 2) return {};
    const std::size_t last = points.size() - 1;
    const auto tangent = [&entity](int code, const Vec3& nearest, const Vec3& next) {
        Vec3 found = entity.place(code);
        if (found.norm() == 0) found = 3 * nearest - next;
        return Vec3(found.norm() > 0 ? found.normalized() : nearest.normalized());
    };
    const Vec3 first = points[1] - points[0], end = points[last] - points[last - 1];
    return spline_through(points, tangent(12, first, last > 1 ? points[2] - points[1] : first),
                          tangent(13, end, last > 1 ? points[last - 1] - points[last - 2] : end));
}

double distance_to_chord(const Vec3& point, const Vec3& from, const Vec3& to) {
    const Vec3 chord = to - from;
    const double length = chord.squaredNorm();
    const double along = length > 0 ? std::clamp((point - from).dot(chord) / length, 0.0, 1.0) : 0;
    return (from + along * chord - point).norm();
}

/// Appends the points after `from` up to `to`. Tests the quarter points too, because an S-curve crosses the middle
/// of its chord.
void divide(const Spline& spline, std::size_t span, double t0, const Vec3& from, double t1, const Vec3& to,
            double chord_error, int depth, std::vector<Vec3>& points) {
    double off = 0;
    for (const double share : {0.25, 0.5, 0.75})
        off = std::max(off, distance_to_chord(spline.at(t0 + share * (t1 - t0), span), from, to));
    if (depth == deepest_halving || points.size() > most_spline_points || off <= 0.75 * chord_error) {
        points.push_back(to);
        return;
    }
    const double middle = (t0 + t1) / 2;
    const Vec3 at = spline.at(middle, span);
    divide(spline, span, t0, from, middle, at, chord_error, depth + 1, points);
    divide(spline, span, middle, at, t1, to, chord_error, depth + 1, points);
}

}  // namespace

DxfShape dxf_spline(const DxfEntity& entity, double chord_error) {
    Spline spline = spline_of(entity);
    const bool is_closed = spline.is_closed;
    if (spline.controls.empty())
        spline = spline_of_fit_points(entity);
    else if (spline.knots.empty() && spline.degree >= 1 && spline.degree < static_cast<int>(spline.controls.size()))
        set_uniform_knots(spline);
    if (!spline.is_whole()) return {};
    const auto first = static_cast<std::size_t>(spline.degree);
    DxfShape shape;
    shape.points.push_back(spline.at(spline.knots[first], first));
    for (std::size_t span = first; span < spline.controls.size(); ++span) {
        const double t0 = spline.knots[span], t1 = spline.knots[span + 1];
        if (t0 == t1) continue;
        if (shape.points.size() == 1) shape.points.front() = spline.at(t0, span);
        // A span may bend as often as its degree, so it starts with a few chords.
        const int parts = spline.degree == 1 ? 1 : 4;
        for (int i = 0; i < parts; ++i) {
            const double a = t0 + (t1 - t0) * i / parts, b = t0 + (t1 - t0) * (i + 1) / parts;
            divide(spline, span, a, shape.points.back(), b, spline.at(b, span), chord_error, 0, shape.points);
        }
    }
    const double gap = (shape.points.front() - shape.points.back()).norm();
    shape.is_closed = shape.points.size() > 2 && (is_closed || gap == 0) && gap <= chord_error;
    if (shape.is_closed) shape.points.pop_back();
    return shape;
}

}  // namespace ripstop
