#include <algorithm>
#include <optional>

#include "ripstop/geometry/polygon.h"
#include "ripstop/geometry/predicates.h"
#include "ripstop/geometry/triangle.h"

namespace ripstop {
namespace {

struct Edge {
    Vec2 from, to;
    int index = 0;
    Vec2 lower() const { return from.cwiseMin(to); }
    Vec2 upper() const { return from.cwiseMax(to); }
};

std::vector<Edge> edges_with_length(const Points2& polygon) {
    std::vector<Vec2> corners;
    for (Eigen::Index i = 0; i < polygon.rows(); ++i) {
        const Vec2 p = polygon.row(i);
        if (corners.empty() || p != corners.back()) corners.push_back(p);
    }
    while (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
    std::vector<Edge> edges;
    for (std::size_t i = 0; i < corners.size(); ++i)
        edges.push_back({corners[i], corners[(i + 1) % corners.size()], static_cast<int>(i)});
    return edges;
}

bool lies_on(const Vec2& point, const Edge& edge, int side) {
    return side == 0 && (point.array() >= edge.lower().array()).all() && (point.array() <= edge.upper().array()).all();
}

/// The point where two non-adjacent edges meet. Each edge owns its start and not its end, so a corner on another edge
/// is found once and not for both edges that share it.
std::optional<Vec2> meeting(const Edge& e, const Edge& f) {
    const int f_from = orient2d(e.from, e.to, f.from), f_to = orient2d(e.from, e.to, f.to);
    if (f_from * f_to > 0) return std::nullopt;
    const int e_from = orient2d(f.from, f.to, e.from), e_to = orient2d(f.from, f.to, e.to);
    if (e_from * e_to > 0) return std::nullopt;
    if (f_from * f_to < 0 && e_from * e_to < 0) {
        const Vec2 d = e.to - e.from;
        const double across = cross(d, f.to - f.from);
        if (across == 0) return Vec2((f.from + f.to) / 2);
        return Vec2(e.from + std::clamp(cross(f.from - e.from, f.to - f.from) / across, 0.0, 1.0) * d);
    }
    if (f.from != e.to && lies_on(f.from, e, f_from)) return f.from;
    if (e.from != f.to && lies_on(e.from, f, e_from)) return e.from;
    return std::nullopt;
}

/// The common corner of `e` and the next edge, if that folds back onto `e`.
std::optional<Vec2> fold(const Edge& e, const Edge& next) {
    const bool back = orient2d(e.from, e.to, next.to) == 0 && (e.from - e.to).dot(next.to - e.to) > 0;
    return back ? std::optional<Vec2>(e.to) : std::nullopt;
}

}  // namespace

SelfIntersections self_intersections(const Points2& polygon) {
    std::vector<Edge> edges = edges_with_length(polygon);
    const int count = static_cast<int>(edges.size());
    SelfIntersections result;
    if (count < 3) return result;
    const Vec2 size = polygon.colwise().maxCoeff() - polygon.colwise().minCoeff();
    const int along = size.x() >= size.y() ? 0 : 1;
    std::stable_sort(edges.begin(), edges.end(),
                     [along](const Edge& e, const Edge& f) { return e.lower()[along] < f.lower()[along]; });
    int first = count;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const Vec2 lower = edges[i].lower(), upper = edges[i].upper();
        for (std::size_t j = i + 1; j < edges.size() && edges[j].lower()[along] <= upper[along]; ++j) {
            if (edges[j].lower()[1 - along] > upper[1 - along] || edges[j].upper()[1 - along] < lower[1 - along])
                continue;
            const bool in_order = edges[i].index < edges[j].index;
            const Edge& e = in_order ? edges[i] : edges[j];
            const Edge& f = in_order ? edges[j] : edges[i];
            std::optional<Vec2> place;
            if (f.index == e.index + 1)
                place = fold(e, f);
            else if (e.index == 0 && f.index == count - 1)
                place = fold(f, e);
            else
                place = meeting(e, f);
            if (!place) continue;
            ++result.count;
            if (e.index < first) {
                first = e.index;
                result.first = *place;
            }
        }
    }
    return result;
}

}  // namespace ripstop
