#include "ripstop/pattern/cut/allowance_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "ripstop/geometry/triangle.h"

namespace ripstop {
namespace {

constexpr double least_slot = 5e-5, half_slot = 5e-4;  // [m] slot between allowances that meet
constexpr double slot_share = 0.1;                     // share of the room on each side
constexpr double narrowest_mitre = 0.5;                // cosine; sharper corners are cut across at twice the allowance
constexpr double never = std::numeric_limits<double>::infinity();

struct Ray {
    Vec2 from, way;
    Vec2 at(double reach) const { return from + reach * way; }
};

void meet_point(const Ray& ray, const SewSegment& segment, double along, BallContact& contact) {
    const Vec2 point = segment.at(along), there = point - ray.from;
    const double ahead = ray.way.dot(there);
    if (!(ahead > 0)) return;
    const double reach = there.squaredNorm() / (2 * ahead);
    const bool is_outside = (ray.at(reach) - point).dot(segment.outward) >= -1e-9;
    if (is_outside && reach < contact.reach) contact = {reach, point};
}

/// The smallest reach, not below `least`, at which the ray enters the polygon.
double enters(const Ray& ray, const std::vector<Vec2>& polygon, double least) {
    std::vector<double> crossings;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec2 a = polygon[i] - ray.from, b = polygon[(i + 1) % polygon.size()] - ray.from;
        const double side_a = cross(ray.way, a), side_b = cross(ray.way, b);
        if ((side_a >= 0) == (side_b >= 0)) continue;
        crossings.push_back(ray.way.dot(a) + side_a / (side_a - side_b) * ray.way.dot(b - a));
    }
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
        if (crossings[i + 1] > least) return std::max(crossings[i], least);
    return never;
}

std::vector<Vec2> allowance_of(const SewSegment& segment, const SewContour::Part& part) {
    const Vec2 out = (segment.allowance + least_slot) * segment.outward;
    return {segment.at(part.from), segment.at(part.to), segment.at(part.to) + out, segment.at(part.from) + out};
}

struct AllowanceBox {
    Vec2 lower, upper;
    explicit AllowanceBox(const Vec2& point) : lower(point), upper(point) {}
    void add(const std::vector<Vec2>& points) {
        for (const Vec2& point : points) {
            lower = lower.cwiseMin(point);
            upper = upper.cwiseMax(point);
        }
    }
    bool meets(const AllowanceBox& other) const {
        return (lower.array() <= other.upper.array()).all() && (other.lower.array() <= upper.array()).all();
    }
};

}  // namespace

BallContact ball_contact(const Vec2& from, const Vec2& way, const SewSegment& segment, const SewContour::Part& part) {
    const Ray ray{from, way};
    BallContact contact;
    const double distance = (ray.from - segment.from).dot(segment.outward);
    const double closing = 1 - ray.way.dot(segment.outward);
    if (distance >= 0 && closing > 1e-9) {
        const double reach = distance / closing;
        const double along = (ray.at(reach) - segment.from).dot(segment.way);
        if (along >= part.from && along <= part.to) return {reach, segment.at(along)};
    }
    meet_point(ray, segment, part.from, contact);
    meet_point(ray, segment, part.to, contact);
    return contact;
}

std::vector<Vec2> points_round(const SewContour& contour, std::size_t segment, double reach_in, double reach_out) {
    if (!contour.turns_outward(segment)) return {};
    const SewCorner corner = contour.corner(segment, reach_in, reach_out);
    if (contour.starts_edge(segment)) return corner_points(corner);
    const Vec2 middle = (corner.away_in() + corner.away_out()).normalized();
    const double cosine = std::max(middle.dot(corner.away_out()), narrowest_mitre);
    return {corner.at + std::min(reach_in, reach_out) / cosine * middle};
}

AllowanceFit::AllowanceFit(const SewContour& contour) : contour_(contour), near_(contour.segments().size()) {
    const auto& segments = contour_.segments();
    for (std::size_t i = 0; i < segments.size(); ++i) {
        const double in = segments[contour_.before(i)].allowance + least_slot, out = segments[i].allowance + least_slot;
        std::vector<Vec2> round = points_round(contour_, i, in, out);
        if (contour_.turns_outward(i)) {
            const SewCorner corner = contour_.corner(i, in, out);
            round.insert(round.begin(), {corner.at, corner.end_in()});
            round.push_back(corner.end_out());
        }
        corners_.push_back(std::move(round));
    }
    find_near();
}

void AllowanceFit::find_near() {
    const auto& segments = contour_.segments();
    std::vector<AllowanceBox> bounds;
    for (std::size_t i = 0; i < segments.size(); ++i) {
        AllowanceBox box(segments[i].from);
        box.add(allowance_of(segments[i], {0, segments[i].length}));
        box.add(corners_[i]);
        box.add(corners_[contour_.next(i)]);
        box.lower.array() -= least_slot;
        box.upper.array() += least_slot;
        bounds.push_back(box);
    }
    std::vector<std::size_t> order(segments.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return bounds[a].lower.x() < bounds[b].lower.x(); });
    for (std::size_t k = 0; k < order.size(); ++k)
        for (std::size_t l = k + 1; l < order.size(); ++l) {
            const std::size_t a = order[k], b = order[l];
            if (bounds[b].lower.x() > bounds[a].upper.x()) break;
            if (!bounds[a].meets(bounds[b]) || !contour_.may_be_apart(a, b)) continue;
            near_[a].push_back(b);
            near_[b].push_back(a);
        }
    for (auto& list : near_) std::sort(list.begin(), list.end());
}

ReachLimit AllowanceFit::limit(const SewPlace& place, const Vec2& direction, double wanted) const {
    const auto& segments = contour_.segments();
    const Ray ray{segments[place.segment].at(place.along), direction};
    std::vector<Facing> facing;
    BallContact nearest;
    int met = -1;
    for (const std::size_t other : near_[place.segment]) {
        const SewContour::Part part = contour_.part_apart(place, other);
        if (!(part.to > part.from)) continue;
        facing.push_back({other, part});
        const BallContact contact = ball_contact(ray.from - least_slot * direction, direction, segments[other], part);
        if (!(contact.reach < nearest.reach)) continue;
        nearest = contact;
        met = static_cast<int>(other);
    }
    const double least = nearest.reach - least_slot;
    if (!(least < wanted)) return {wanted};
    double reach = wanted;
    for (const auto& [other, part] : facing) {
        reach = std::min(reach, enters(ray, allowance_of(segments[other], part), least));
        const std::size_t next = contour_.next(other);
        if (part.from == 0) reach = std::min(reach, enters(ray, corners_[other], least));
        if (part.to == segments[other].length) reach = std::min(reach, enters(ray, corners_[next], least));
    }
    if (!(reach < wanted)) return {wanted};
    const double slot = std::clamp(std::min(slot_share * reach, wanted - reach), 0.0, half_slot);
    return {reach - slot, met, (nearest.at - ray.from).norm()};
}

}  // namespace ripstop
