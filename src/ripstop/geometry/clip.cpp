#include "ripstop/geometry/clip.h"

#include <algorithm>

namespace ripstop {
namespace {

/// An end of a clipped segment: its parameter `t` along the segment and, if it lies on a side of the box, the `axis`
/// of that side (else -1) and its coordinate `bound`.
struct End {
    double t = 0;
    int axis = -1;
    double bound = 0;

    Vec2 on(const Vec2& a, const Vec2& b) const {
        Vec2 point = t == 0 ? a : t == 1 ? b : Vec2(a + t * (b - a));
        if (axis >= 0) point[axis] = bound;
        return point;
    }
};

/// Liang-Barsky clipping: each side of the box moves the start forward or the end back. Returns false if nothing is
/// left.
bool clip_segment(const Vec2& a, const Vec2& b, const Vec2& lower, const Vec2& upper, End& start, End& end) {
    start = {0};
    end = {1};
    for (int axis = 0; axis < 2; ++axis) {
        const double way = b[axis] - a[axis];
        if (way == 0) {
            if (a[axis] < lower[axis] || a[axis] > upper[axis]) return false;
            continue;
        }
        const double near = way > 0 ? lower[axis] : upper[axis], far = way > 0 ? upper[axis] : lower[axis];
        const double enters = (near - a[axis]) / way, leaves = (far - a[axis]) / way;
        if (enters > start.t) start = {enters, axis, near};
        if (leaves < end.t) end = {leaves, axis, far};
    }
    return start.t < end.t;
}

Points2 rows_of(const std::vector<Vec2>& points) {
    Points2 rows(static_cast<Eigen::Index>(points.size()), 2);
    for (std::size_t i = 0; i < points.size(); ++i) rows.row(static_cast<Eigen::Index>(i)) = points[i].transpose();
    return rows;
}

}  // namespace

std::vector<LinePart> clip_to_box(const Points2& line, const Vec2& lower, const Vec2& upper) {
    std::vector<LinePart> parts;
    std::vector<Vec2> run;
    double walked = 0, run_from = 0;
    const auto finish = [&] {
        if (run.size() > 1) parts.push_back({rows_of(run), run_from});
        run.clear();
    };
    for (Eigen::Index i = 0; i + 1 < line.rows(); ++i) {
        const Vec2 a = line.row(i), b = line.row(i + 1);
        const double length = (b - a).norm();
        End start, end;
        if (length > 0) {
            const bool any = clip_segment(a, b, lower, upper, start, end);
            if (!any || start.t > 0) finish();
            if (any && run.empty()) {
                run.push_back(start.on(a, b));
                run_from = walked + start.t * length;
            }
            if (any) run.push_back(end.on(a, b));
            if (any && end.t < 1) finish();
        }
        walked += length;
    }
    finish();
    return parts;
}

Points2 closed_line(const Points2& polygon) {
    if (polygon.rows() == 0) return polygon;
    Points2 line(polygon.rows() + 1, 2);
    line << polygon, polygon.row(0);
    return line;
}

}  // namespace ripstop
