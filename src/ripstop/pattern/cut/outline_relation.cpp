#include "ripstop/pattern/cut/outline_relation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ripstop/geometry/predicates.h"
#include "ripstop/geometry/triangle.h"

namespace ripstop {
namespace {

constexpr Eigen::Index most_rows = 64;  // tall edges are stored in every row

double distance_to_edge(const Vec2& from, const Vec2& to, const Vec2& point) {
    const Vec2 along = to - from;
    const double length2 = along.squaredNorm();
    const double t = length2 > 0 ? std::clamp(along.dot(point - from) / length2, 0.0, 1.0) : 0.0;
    return (from + t * along - point).norm();
}

struct Edge {
    Vec2 from, to;
    Eigen::Index index = 0;
    int owner = 0;
    Vec2 lower() const { return from.cwiseMin(to); }
    Vec2 upper() const { return from.cwiseMax(to); }
};

/// The intersection of an edge with the other outline.
struct EdgeCut {
    Eigen::Index edge;
    Vec2 at;
};

struct Meetings {
    std::vector<EdgeCut> cuts[2];
    bool none() const { return cuts[0].empty() && cuts[1].empty(); }
    void add(const Edge& e, const Edge& f, const Vec2& at) {
        cuts[e.owner].push_back({e.index, at});
        cuts[f.owner].push_back({f.index, at});
    }
};

void add_near(std::vector<Edge>& edges, const IndexedOutline& outline, const IndexedOutline& other, int owner,
              double reach = 0) {
    for (Eigen::Index i = 0; i < outline.points().rows(); ++i) {
        const Edge edge{outline.corner(i), outline.corner(i + 1), i, owner};
        const bool is_apart = (edge.lower().array() > other.upper().array() + reach).any() ||
                              (edge.upper().array() < other.lower().array() - reach).any();
        if (!is_apart) edges.push_back(edge);
    }
}

bool lies_on(const Vec2& point, const Edge& edge, int side) {
    return side == 0 && (point.array() >= edge.lower().array()).all() && (point.array() <= edge.upper().array()).all();
}

/// The side of an edge on which a point lies. Skips the exact test for shared corners.
int side_of(const Edge& edge, const Vec2& point) {
    return point == edge.from || point == edge.to ? 0 : orient2d(edge.from, edge.to, point);
}

void meet(const Edge& e, const Edge& f, Meetings& meetings) {
    const int f_from = side_of(e, f.from), f_to = side_of(e, f.to);
    if (f_from * f_to > 0) return;
    const int e_from = side_of(f, e.from), e_to = side_of(f, e.to);
    if (e_from * e_to > 0) return;
    if (f_from * f_to < 0 && e_from * e_to < 0) {
        const Vec2 d = e.to - e.from;
        const double across = cross(d, f.to - f.from);
        const double t = across == 0 ? 0.5 : std::clamp(cross(f.from - e.from, f.to - f.from) / across, 0.0, 1.0);
        meetings.add(e, f, e.from + t * d);
        return;
    }
    if (lies_on(f.from, e, f_from)) meetings.add(e, f, f.from);
    if (lies_on(f.to, e, f_to)) meetings.add(e, f, f.to);
    if (lies_on(e.from, f, e_from)) meetings.add(e, f, e.from);
    if (lies_on(e.to, f, e_to)) meetings.add(e, f, e.to);
}

/// Calls `look` for each pair of edges, one of each outline, whose boxes come within `reach` of each other.
template <class Look>
void each_near_pair(const IndexedOutline& first, const IndexedOutline& second, double reach, Look&& look) {
    std::vector<Edge> edges;
    add_near(edges, first, second, 0, reach);
    add_near(edges, second, first, 1, reach);
    const Vec2 size = first.upper().cwiseMin(second.upper()) - first.lower().cwiseMax(second.lower());
    const int along = size.x() >= size.y() ? 0 : 1;
    std::sort(edges.begin(), edges.end(),
              [along](const Edge& e, const Edge& f) { return e.lower()[along] < f.lower()[along]; });
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const Vec2 lower = edges[i].lower(), upper = edges[i].upper();
        for (std::size_t j = i + 1; j < edges.size() && edges[j].lower()[along] <= upper[along] + reach; ++j)
            if (edges[i].owner != edges[j].owner && edges[j].lower()[1 - along] <= upper[1 - along] + reach &&
                edges[j].upper()[1 - along] >= lower[1 - along] - reach)
                look(edges[i], edges[j]);
    }
}

Meetings find_meetings(const IndexedOutline& first, const IndexedOutline& second) {
    Meetings meetings;
    each_near_pair(first, second, 0, [&](const Edge& e, const Edge& f) { meet(e, f, meetings); });
    return meetings;
}

/// The corners, and a point on every part of an edge between intersections: such a part lies on one side.
std::vector<Vec2> samples_of(const IndexedOutline& outline, std::vector<EdgeCut> cuts) {
    std::sort(cuts.begin(), cuts.end(), [&outline](const EdgeCut& a, const EdgeCut& b) {
        const Vec2 from = outline.corner(a.edge);
        return a.edge != b.edge ? a.edge < b.edge : (a.at - from).squaredNorm() < (b.at - from).squaredNorm();
    });
    std::vector<Vec2> samples;
    for (Eigen::Index i = 0; i < outline.points().rows(); ++i) samples.push_back(outline.corner(i));
    for (std::size_t i = 0; i < cuts.size(); ++i) {
        const bool is_first = i == 0 || cuts[i - 1].edge != cuts[i].edge;
        const bool is_last = i + 1 == cuts.size() || cuts[i + 1].edge != cuts[i].edge;
        samples.push_back(((is_first ? outline.corner(cuts[i].edge) : cuts[i - 1].at) + cuts[i].at) / 2);
        if (is_last) samples.push_back((cuts[i].at + outline.corner(cuts[i].edge + 1)) / 2);
    }
    return samples;
}

/// How far the samples lie inside and outside of the other outline; samples on its line do not count.
struct Sides {
    Protrusion inside;
    bool is_out = false;
};

Sides sides_of(const std::vector<Vec2>& samples, const IndexedOutline& other, double tolerance) {
    Sides sides;
    for (const Vec2& sample : samples) {
        if (other.is_near(sample, tolerance)) continue;
        if (!other.contains(sample)) {
            sides.is_out = true;
            continue;
        }
        const double distance = other.distance(sample);
        if (distance > sides.inside.distance) sides.inside = {distance, sample};
    }
    return sides;
}

}  // namespace

IndexedOutline::IndexedOutline(const Points2& polygon)
    : points_(polygon), lower_(polygon.colwise().minCoeff()), upper_(polygon.colwise().maxCoeff()) {
    rows_.resize(static_cast<std::size_t>(std::min(most_rows, polygon.rows())));
    row_height_ = (upper_.y() - lower_.y()) / static_cast<double>(rows_.size());
    for (Eigen::Index i = 0; i < points_.rows(); ++i) {
        const double a = corner(i).y(), b = corner(i + 1).y();
        for (std::size_t row = row_of(std::min(a, b)); row <= row_of(std::max(a, b)); ++row) rows_[row].push_back(i);
    }
}

std::size_t IndexedOutline::row_of(double y) const {
    if (!(row_height_ > 0) || y <= lower_.y()) return 0;
    return static_cast<std::size_t>(std::min((y - lower_.y()) / row_height_, static_cast<double>(rows_.size() - 1)));
}

bool IndexedOutline::contains(const Vec2& point) const {
    if ((point.array() < lower_.array()).any() || (point.array() > upper_.array()).any()) return false;
    int winding = 0;
    for (const Eigen::Index i : rows_[row_of(point.y())]) {
        const Vec2 from = corner(i), to = corner(i + 1);
        const bool is_from_below = from.y() <= point.y(), is_to_below = to.y() <= point.y();
        if (is_from_below == is_to_below) continue;
        const int side = orient2d(from, to, point);
        if (is_from_below && side > 0) ++winding;
        if (is_to_below && side < 0) --winding;
    }
    return winding != 0;
}

bool IndexedOutline::is_near(const Vec2& point, double reach) const {
    if ((point.array() < lower_.array() - reach).any() || (point.array() > upper_.array() + reach).any()) return false;
    for (std::size_t row = row_of(point.y() - reach); row <= row_of(point.y() + reach); ++row)
        for (const Eigen::Index i : rows_[row])
            if (distance_to_edge(corner(i), corner(i + 1), point) <= reach) return true;
    return false;
}

double IndexedOutline::distance(const Vec2& point) const {
    double best = std::numeric_limits<double>::infinity();
    const auto look = [&](std::size_t row) {
        for (const Eigen::Index i : rows_[row])
            best = std::min(best, distance_to_edge(corner(i), corner(i + 1), point));
    };
    const std::size_t middle = row_of(point.y());
    look(middle);
    for (std::size_t away = 1; away < rows_.size(); ++away) {
        if (best <= static_cast<double>(away - 1) * row_height_) break;
        if (away <= middle) look(middle - away);
        if (middle + away < rows_.size()) look(middle + away);
    }
    return best;
}

OutlineRelation relate(const IndexedOutline& first, const IndexedOutline& second, double tolerance) {
    if (first.points().rows() == second.points().rows() && first.points() == second.points())
        return {Relation::same, {}};
    const Meetings meetings = find_meetings(first, second);
    std::vector<Vec2> of_first{first.corner(0)}, of_second{second.corner(0)};
    if (!meetings.none() || second.is_near(of_first.front(), tolerance) ||
        first.is_near(of_second.front(), tolerance)) {
        of_first = samples_of(first, meetings.cuts[0]);
        of_second = samples_of(second, meetings.cuts[1]);
    }
    const Sides sides = sides_of(of_first, second, tolerance), others = sides_of(of_second, first, tolerance);
    if (!sides.is_out && !others.is_out) return {Relation::same, {}};
    const Protrusion& deepest = sides.inside.distance > others.inside.distance ? sides.inside : others.inside;
    if (deepest.distance == 0) return {Relation::apart, {}};
    if (!sides.is_out) return {Relation::within, {}};
    if (!others.is_out) return {Relation::around, {}};
    return {Relation::crossing, deepest};
}

CommonSide common_side(const IndexedOutline& first, const IndexedOutline& second, double tolerance) {
    CommonSide common;
    each_near_pair(first, second, tolerance, [&](const Edge& e, const Edge& f) {
        const double length = (e.to - e.from).norm();
        if (length <= tolerance) return;
        const Vec2 along = (e.to - e.from) / length;
        const double from = along.dot(f.from - e.from), to = along.dot(f.to - e.from);
        const double start = std::max(0.0, std::min(from, to)), end = std::min(length, std::max(from, to));
        if (end - start <= tolerance) return;
        for (const double t : {start, end})
            if (distance_to_edge(f.from, f.to, e.from + t * along) > tolerance) return;
        if (common.length == 0) common.at = e.from + start * along;
        common.length += end - start;
    });
    return common;
}

Protrusion reach_outside(const IndexedOutline& first, const IndexedOutline& second) {
    Protrusion reach;
    for (const Vec2& sample : samples_of(first, find_meetings(first, second).cuts[0])) {
        if (second.contains(sample)) continue;
        const double distance = second.distance(sample);
        if (distance > reach.distance) reach = {distance, sample};
    }
    return reach;
}

}  // namespace ripstop
