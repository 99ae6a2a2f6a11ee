#include "ripstop/pattern/cut/sew_contour.h"

#include <cmath>
#include <numbers>

#include "ripstop/geometry/triangle.h"

namespace ripstop {
namespace {

constexpr double same_point = 1e-9;                           // [m]
constexpr double corner_reach = 2;                            // times both allowances
constexpr double pocket_turn = 127 * std::numbers::pi / 180;  // [rad]: turn of the corner whose sides have that length
constexpr double least_edge = 0.2;                            // times its allowance

}  // namespace

SewContour::SewContour(const std::vector<AllowedEdge>& edges) {
    for (std::size_t e = 0; e < edges.size(); ++e) {
        const Points2& line = edges[e].sew_line;
        const double start = length_;
        for (Eigen::Index i = 0; i + 1 < line.rows(); ++i) {
            const Vec2 from = line.row(i), to = line.row(i + 1);
            const double length = (to - from).norm();
            if (length < same_point) continue;
            const Vec2 way = (to - from) / length;
            segments_.push_back({from,
                                 to,
                                 way,
                                 {way.y(), -way.x()},
                                 length,
                                 length_,
                                 static_cast<int>(e),
                                 edges[e].allowance,
                                 edges[e].corner});
            length_ += length;
        }
        edges_.push_back({start, length_ - start, length_ - start >= least_edge * edges[e].allowance});
    }
    turned_.assign(segments_.size() + 1, 0);
    swept_.assign(segments_.size() + 1, 0);
    for (std::size_t i = 0; i < segments_.size(); ++i) {
        const Vec2 &here = segments_[i].way, &after = segments_[next(i)].way;
        turned_[i + 1] = turned_[i] + std::atan2(cross(here, after), here.dot(after));
        swept_[i + 1] = swept_[i] + cross(segments_[i].from, segments_[i].to) / 2;
    }
}

SewCorner SewContour::corner(std::size_t segment, double reach_in, double reach_out) const {
    const SewSegment &in = segments_[before(segment)], &out = segments_[segment];
    return {out.from, in.way, out.way, reach_in, reach_out, in.rule, out.rule};
}

bool SewContour::turns_outward(std::size_t segment) const {
    return cross(segments_[before(segment)].way, segments_[segment].way) > 0;
}

bool SewContour::starts_edge(std::size_t segment) const {
    return segments_[segment].edge != segments_[before(segment)].edge ||
           segments_[segment].start == edges_[static_cast<std::size_t>(segments_[segment].edge)].start;
}

double SewContour::forward_length(const SewPlace& a, const SewPlace& b) const {
    const double way = segments_[b.segment].start + b.along - segments_[a.segment].start - a.along;
    return way >= 0 ? way : way + length_;
}

double SewContour::forward_turn(const SewPlace& a, const SewPlace& b) const {
    const bool is_round = b.segment < a.segment || (b.segment == a.segment && b.along < a.along);
    return turned_[b.segment] - turned_[a.segment] + (is_round ? turned_.back() : 0);
}

/// The signed area enclosed by the sew line from a to b and the straight line back.
double SewContour::forward_area(const SewPlace& a, const SewPlace& b) const {
    const Vec2 from = segments_[a.segment].at(a.along), to = segments_[b.segment].at(b.along);
    const bool is_round = b.segment < a.segment || (b.segment == a.segment && b.along < a.along);
    const double swept = swept_[b.segment] - swept_[a.segment] + (is_round ? swept_.back() : 0);
    return swept +
           (cross(segments_[b.segment].from, to) - cross(segments_[a.segment].from, from) + cross(to, from)) / 2;
}

Pocket SewContour::pocket(const SewPlace& a, const SewPlace& b) const {
    const bool forward = forward_area(a, b) <= forward_area(b, a);
    return forward ? Pocket{forward_length(a, b), -forward_turn(a, b), true}
                   : Pocket{forward_length(b, a), -forward_turn(b, a), false};
}

bool SewContour::holds_edge(const SewPlace& a, const SewPlace& b) const {
    const double whole = forward_length(a, b), from = segments_[a.segment].start + a.along;
    for (const Edge& edge : edges_) {
        const double ahead = edge.start >= from ? edge.start - from : edge.start - from + length_;
        if (edge.counts && ahead + edge.length <= whole) return true;
    }
    return false;
}

bool SewContour::is_open(const Pocket& pocket, const SewPlace& a, const SewPlace& b) const {
    return pocket.turn > pocket_turn && (pocket.forward ? holds_edge(a, b) : holds_edge(b, a));
}

bool SewContour::is_apart(const SewPlace& a, const SewPlace& b) const {
    const Pocket between = pocket(a, b);
    const double both = segments_[a.segment].allowance + segments_[b.segment].allowance;
    return between.length > corner_reach * both || is_open(between, a, b);
}

bool SewContour::may_be_apart(std::size_t a, std::size_t b) const {
    const double both = segments_[a].length + segments_[b].length;
    const auto span = [&](std::size_t first, std::size_t last) {  // contains both
        const double length = forward_length({first, 0}, {last, segments_[last].length});
        return length < both - same_point ? length_ : length;
    };
    const double forward = span(a, b), backward = span(b, a);
    if (std::min(forward, backward) > corner_reach * (segments_[a].allowance + segments_[b].allowance)) return true;
    return forward <= backward ? holds_edge({a, 0}, {b, segments_[b].length})
                               : holds_edge({b, 0}, {a, segments_[a].length});
}

SewContour::Part SewContour::part_apart(const SewPlace& place, std::size_t other) const {
    const SewSegment& segment = segments_[other];
    if (other == place.segment) return {};
    const SewPlace middle{other, segment.length / 2};
    const Pocket between = pocket(place, middle);
    if (is_open(between, place, middle)) return {0, segment.length};
    const double least = corner_reach * (segments_[place.segment].allowance + segment.allowance);
    const double missing = least - between.length;  // starting from the middle
    if (between.forward) return {std::max(0.0, segment.length / 2 + missing), segment.length};
    return {0, std::min(segment.length, segment.length / 2 - missing)};
}

}  // namespace ripstop
