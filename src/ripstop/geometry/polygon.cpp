#include "ripstop/geometry/polygon.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

#include "ripstop/geometry/predicates.h"
#include "ripstop/geometry/triangle.h"

namespace ripstop {
namespace {

Vec2 corner(const Points2& polygon, Eigen::Index i) {
    return polygon.row(i < polygon.rows() ? i : i - polygon.rows());
}

/// Whether the segment p -> q meets the rectangle |x| <= half.x, |y| <= half.y, by clipping to the two slabs.
bool meets_rectangle(const Vec2& p, const Vec2& q, const Vec2& half) {
    double from = 0, to = 1;
    for (int k = 0; k < 2; ++k) {
        const double step = q[k] - p[k];
        if (step == 0) {
            if (std::abs(p[k]) > half[k]) return false;
            continue;
        }
        const double enter = (-half[k] - p[k]) / step;
        const double leave = (half[k] - p[k]) / step;
        from = std::max(from, std::min(enter, leave));
        to = std::min(to, std::max(enter, leave));
    }
    return from <= to;
}

double squared_distance_to_segment(const Vec2& a, const Vec2& b, const Vec2& point) {
    const Vec2 along = b - a;
    const double length2 = along.squaredNorm();
    const double t = length2 > 0 ? std::clamp(along.dot(point - a) / length2, 0.0, 1.0) : 0.0;
    return (a + t * along - point).squaredNorm();
}

struct Cell {
    Vec2 centre;
    double half = 0;
    double distance = 0;  ///< signed distance to the outline, negative outside
    double best() const { return distance + half * std::sqrt(2.0); }
    bool operator<(const Cell& other) const { return best() < other.best(); }
};

Cell make_cell(const Points2& polygon, const Vec2& centre, double half) {
    const double distance = distance_to_outline(polygon, centre);
    return {centre, half, contains(polygon, centre) ? distance : -distance};
}

}  // namespace

double signed_area(const Points2& polygon) {
    if (polygon.rows() < 3) return 0;
    // Coordinates relative to a corner: far from the origin the shoelace terms cancel.
    const Vec2 origin = polygon.row(0);
    double twice = 0;
    for (Eigen::Index i = 1; i + 1 < polygon.rows(); ++i)
        twice += cross(corner(polygon, i) - origin, corner(polygon, i + 1) - origin);
    return twice / 2;
}

Vec2 area_centroid(const Points2& polygon) {
    const Vec2 start = polygon.row(0);  // coordinates relative to a corner keep their digits far from the origin
    Vec2 sum = Vec2::Zero();
    double area = 0;
    for (Eigen::Index i = 1; i + 1 < polygon.rows(); ++i) {
        const Vec2 a = Vec2(polygon.row(i)) - start, b = Vec2(polygon.row(i + 1)) - start;
        const double twice = cross(a, b);
        sum += twice * (a + b) / 3;
        area += twice;
    }
    return start + sum / area;
}

double perimeter(const Points2& polygon) {
    double sum = 0;
    for (Eigen::Index i = 0; i < polygon.rows(); ++i) sum += (corner(polygon, i + 1) - corner(polygon, i)).norm();
    return sum;
}

bool contains(const Points2& polygon, const Vec2& point) {
    int winding = 0;
    for (Eigen::Index i = 0; i < polygon.rows(); ++i) {
        const Vec2 a = corner(polygon, i);
        const Vec2 b = corner(polygon, i + 1);
        if (a.y() <= point.y() && b.y() > point.y() && orient2d(a, b, point) > 0) ++winding;
        if (a.y() > point.y() && b.y() <= point.y() && orient2d(a, b, point) < 0) --winding;
    }
    return winding != 0;
}

double distance_to_outline(const Points2& polygon, const Vec2& point) {
    double best = std::numeric_limits<double>::infinity();
    for (Eigen::Index i = 0; i < polygon.rows(); ++i)
        best = std::min(best, squared_distance_to_segment(corner(polygon, i), corner(polygon, i + 1), point));
    return std::sqrt(best);
}

double distance_along(const Points2& polygon, const Vec2& point, const Vec2& way) {
    double best = std::numeric_limits<double>::infinity();
    for (Eigen::Index i = 0; i < polygon.rows(); ++i) {
        const Vec2 a = corner(polygon, i) - point, b = corner(polygon, i + 1) - point;
        const double side_a = cross(way, a), side_b = cross(way, b);
        if ((side_a >= 0) == (side_b >= 0)) continue;
        const double distance = way.dot(a) + side_a / (side_a - side_b) * way.dot(b - a);
        if (distance >= 0) best = std::min(best, distance);
    }
    return best;
}

bool contains(const Points2& polygon, const Box& box) {
    if (!contains(polygon, box.centre)) return false;
    const double c = std::cos(box.turn), s = std::sin(box.turn);
    const auto in_box_frame = [&](const Vec2& p) {
        const Vec2 d = p - box.centre;
        return Vec2(c * d.x() + s * d.y(), c * d.y() - s * d.x());
    };
    for (Eigen::Index i = 0; i < polygon.rows(); ++i)
        if (meets_rectangle(in_box_frame(corner(polygon, i)), in_box_frame(corner(polygon, i + 1)), box.half))
            return false;
    return true;
}

std::vector<std::array<double, 2>> horizontal_chords(const Points2& polygon, double y) {
    std::vector<double> crossings;
    for (Eigen::Index i = 0; i < polygon.rows(); ++i) {
        const Vec2 a = corner(polygon, i);
        const Vec2 b = corner(polygon, i + 1);
        if ((a.y() <= y) == (b.y() <= y)) continue;
        crossings.push_back(a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
    }
    std::sort(crossings.begin(), crossings.end());
    std::vector<std::array<double, 2>> chords;
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) chords.push_back({crossings[i], crossings[i + 1]});
    return chords;
}

Circle largest_circle_inside(const Points2& polygon, double precision) {
    if (polygon.rows() < 3) return {};
    const Vec2 lower = polygon.colwise().minCoeff();
    const Vec2 size = Vec2(polygon.colwise().maxCoeff()) - lower;
    // Square cells as wide as the polygon's shorter side, but at most 64 in a row.
    const double cell = std::max(size.minCoeff(), size.maxCoeff() / 64);
    Cell best = make_cell(polygon, lower + size / 2, 0);
    if (!(cell > 0)) return {best.centre, 0};
    std::priority_queue<Cell> queue;
    for (double x = 0; x < size.x() || x == 0; x += cell)
        for (double y = 0; y < size.y() || y == 0; y += cell)
            queue.push(make_cell(polygon, lower + Vec2(x + cell / 2, y + cell / 2), cell / 2));
    const double step = std::max(1e-6 * cell, precision);
    while (!queue.empty()) {
        const Cell top = queue.top();
        queue.pop();
        if (top.distance > best.distance) best = top;
        if (top.best() - best.distance <= step) break;
        for (const double dx : {-0.5, 0.5})
            for (const double dy : {-0.5, 0.5})
                queue.push(make_cell(polygon, top.centre + top.half * Vec2(dx, dy), top.half / 2));
    }
    return {best.centre, std::max(0.0, best.distance)};
}

}  // namespace ripstop
