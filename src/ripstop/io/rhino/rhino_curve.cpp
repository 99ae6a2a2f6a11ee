#include "ripstop/io/rhino/rhino_curve.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "ripstop/base/error.h"

namespace ripstop {
namespace {

constexpr RhinoId line_class = rhino_id("4ED7D4DB-E947-11d3-BFE5-0010830122F0"),
                  polyline_class = rhino_id("4ED7D4E6-E947-11d3-BFE5-0010830122F0"),
                  nurbs_class = rhino_id("4ED7D4DD-E947-11d3-BFE5-0010830122F0"),
                  arc_class = rhino_id("CF33BE2A-09B4-11d4-BFFB-0010830122F0"),
                  joined_class = rhino_id("4ED7D4E0-E947-11d3-BFE5-0010830122F0");

constexpr int deepest_curve = 16;             // nesting of joined curves
constexpr double chord_error_share = 0.5e-3;  // share of the curve's size; half of the promise, because only midpoints
                                              // are tested
constexpr int most_pieces = 256;              // for each span of a NURBS curve
constexpr std::size_t most_curve_points = 20000;
constexpr double most_coordinate = 1e12;

using Polyline = std::vector<Vec3>;

Polyline read_line(RhinoBytes data) {
    data.packed_version();
    const Vec3 from = data.point(), to = data.point();
    return {from, to};
}

Polyline read_polyline(RhinoBytes data) {
    data.packed_version();
    Polyline points(data.count(3 * sizeof(double)));
    for (Vec3& p : points) p = data.point();
    return points;
}

/// The sagitta of one of n parts of an arc, relative to the arc's size, is largest for a full circle: 0.0005 at n
/// = 60. For a short arc of angle a it is a / (8 n^2), so n may shrink with the square root of the angle.
Polyline read_arc(RhinoBytes data) {
    data.packed_version();
    const Vec3 centre = data.point(), x = data.point(), y = data.point();
    data.skip(7 * sizeof(double));  // z and the equation of the plane
    const double radius = data.real();
    data.skip(9 * sizeof(double));  // points on the plane
    const double from = data.real(), to = data.real();
    const double turn = std::abs(to - from);
    if (!(turn <= 2 * std::numbers::pi * (1 + 1e-9))) data.refuse("an arc of more than a full turn");
    const int pieces = std::max(2, static_cast<int>(std::ceil(25 * std::sqrt(turn))));
    Polyline points;
    for (int i = 0; i <= pieces; ++i) {
        const double angle = from + (to - from) * i / pieces;
        points.push_back(centre + radius * (std::cos(angle) * x + std::sin(angle) * y));
    }
    return points;
}

/// A NURBS curve in homogeneous coordinates. openNURBS omits the first and the last knot.
struct Nurbs {
    int order = 0;
    std::vector<double> knots;  // #control + order - 2
    std::vector<Eigen::Vector4d> control;

    int spans() const { return static_cast<int>(control.size()) - order + 1; }
    double knot(int i) const { return knots[static_cast<std::size_t>(i)]; }

    /// Evaluates the curve in the given span by de Boor's algorithm; `t` lies between the span's knots.
    Vec3 at(int span, double t) const {
        std::vector<Eigen::Vector4d> p(control.begin() + span, control.begin() + span + order);
        for (int level = 1; level < order; ++level)
            for (int i = order - 1; i >= level; --i) {
                const double low = knot(span + i - 1), high = knot(span + i + order - 1 - level);
                const double s = high > low ? (t - low) / (high - low) : 0;
                const auto k = static_cast<std::size_t>(i);
                p[k] = (1 - s) * p[k - 1] + s * p[k];
            }
        return p.back().head<3>() / p.back()[3];
    }
};

Nurbs read_nurbs(RhinoBytes data) {
    data.packed_version();
    const int dimension = data.integer(), rational = data.integer();
    Nurbs nurbs;
    nurbs.order = data.integer();
    const int count = data.integer();
    data.skip(2 * sizeof(std::int32_t) + 6 * sizeof(double));  // reserved, box
    if (dimension < 1 || dimension > 3 || nurbs.order < 2 || nurbs.order > 32 || count < nurbs.order)
        data.refuse("a NURBS curve of order " + std::to_string(nurbs.order) + " with " + std::to_string(count) +
                    " points in " + std::to_string(dimension) + " dimensions");
    const std::size_t knots = data.count(sizeof(double));
    if (knots != static_cast<std::size_t>(count) + static_cast<std::size_t>(nurbs.order) - 2)
        data.refuse("a NURBS curve with " + std::to_string(knots) + " knots");
    for (std::size_t i = 0; i < knots; ++i) nurbs.knots.push_back(data.real());
    if (!std::is_sorted(nurbs.knots.begin(), nurbs.knots.end())) data.refuse("a NURBS curve with decreasing knots");
    const auto width = static_cast<std::size_t>(dimension + (rational ? 1 : 0));
    if (data.count(width * sizeof(double)) != static_cast<std::size_t>(count))
        data.refuse("a NURBS curve with a wrong number of points");
    for (int i = 0; i < count; ++i) {
        Eigen::Vector4d point(0, 0, 0, 1);
        for (int k = 0; k < dimension; ++k) point[k] = data.real();
        if (rational) point[3] = data.real();
        if (!(point[3] > 0)) data.refuse("a NURBS curve with a weight that is not above zero");
        nurbs.control.push_back(point);
    }
    return nurbs;
}

Polyline points_on(const Nurbs& nurbs) {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector4d& p : nurbs.control) box.extend(Vec3(p.head<3>() / p[3]));
    const double tolerance = chord_error_share * box.diagonal().norm();
    const int first_knot = nurbs.order - 2;
    Polyline points = {nurbs.at(0, nurbs.knot(first_knot))};
    for (int span = 0; span < nurbs.spans() && points.size() < most_curve_points; ++span) {
        const double from = nurbs.knot(first_knot + span), to = nurbs.knot(first_knot + span + 1);
        if (!(to > from)) continue;
        int pieces = 1;
        const auto on_curve = [&](double i) { return nurbs.at(span, from + (to - from) * i / pieces); };
        // A curve may pass through the middle of its chord by chance, so one piece is never enough.
        for (bool fine = nurbs.order == 2; !fine && pieces < most_pieces;) {
            pieces *= 2;
            fine = true;
            for (int i = 0; i < pieces && fine; ++i)
                fine = (on_curve(i + 0.5) - (on_curve(i) + on_curve(i + 1)) / 2).norm() <= tolerance;
        }
        for (int i = 1; i <= pieces; ++i) points.push_back(on_curve(i));
    }
    return points;
}

std::optional<Polyline> read_curve(const RhinoClass& object, int depth);

std::optional<Polyline> read_joined(RhinoBytes data, int depth) {
    data.packed_version();
    const int count = data.integer();
    data.skip(2 * sizeof(std::int32_t) + 6 * sizeof(double));  // reserved, box
    data.skip(data.count(sizeof(double)) * sizeof(double));    // parameters
    Polyline points;
    for (int i = 0; i < count; ++i) {
        const std::optional<Polyline> part = read_curve(read_rhino_class(data), depth + 1);
        if (!part) return std::nullopt;
        const bool goes_on = !points.empty() && !part->empty();
        points.insert(points.end(), part->begin() + (goes_on ? 1 : 0), part->end());
    }
    return points;
}

std::optional<Polyline> read_curve(const RhinoClass& object, int depth) {
    if (depth > deepest_curve) object.data.refuse("joined curves are nested more than 16 deep");
    if (object.id == line_class) return read_line(object.data);
    if (object.id == polyline_class) return read_polyline(object.data);
    if (object.id == arc_class) return read_arc(object.data);
    if (object.id == nurbs_class) return points_on(read_nurbs(object.data));
    if (object.id == joined_class) return read_joined(object.data, depth);
    return std::nullopt;
}

}  // namespace

std::optional<Points3> read_rhino_curve(const RhinoClass& object, const std::string& called) {
    const std::optional<Polyline> points = read_curve(object, 0);
    if (!points) return std::nullopt;
    if (points->size() < 2) object.data.refuse(called + " has fewer than two points");
    Points3 rows(static_cast<Eigen::Index>(points->size()), 3);
    for (std::size_t i = 0; i < points->size(); ++i) rows.row(static_cast<Eigen::Index>(i)) = (*points)[i].transpose();
    if (!rows.allFinite() || rows.cwiseAbs().maxCoeff() >= most_coordinate)
        object.data.refuse(called + " has a coordinate that is not a number below 1e12");
    return rows;
}

}  // namespace ripstop
