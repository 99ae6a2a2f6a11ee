#pragma once

#include <limits>
#include <vector>

#include "ripstop/pattern/cut/sew_contour.h"

namespace ripstop {

/// The largest distance of the cut line from a place of the sew line.
struct ReachLimit {
    double reach = 0;  ///< [m]
    int segment = -1;  ///< the segment of the contour that limits it; -1: none, the reach is as requested
    double gap = 0;    ///< clear width to that segment [m]
};

/// The contact of a growing ball with part of a segment: the ball's radius [m], infinite if there is none, and the
/// place.
struct BallContact {
    double reach = std::numeric_limits<double>::infinity();
    Vec2 at = Vec2::Zero();
};

/// The ball touches `from`, grows along `way` (unit) and first meets the part of the segment from its outside.
BallContact ball_contact(const Vec2& from, const Vec2& way, const SewSegment& segment, const SewContour::Part& part);

/// Divides the room between parts of a sew line that face each other, so that the cut line keeps the topology of
/// the sew line: no allowance overlaps the piece, or another allowance that is apart from it
/// (`SewContour::is_apart`).
///
/// A point x at distance h from its place on the sew line may belong to that place unless it lies in the allowance
/// of a nearer part that is apart. So facing allowances each get half the gap g; or the narrower one fits whole
/// and the wider one gets the rest:
///
///     h = min(a, max(g/2, g - b))        between parallel lines with allowances a and b
///
/// In general h is the longer of two lengths. One is the radius of the ball that touches the sew line at the place
/// (|q - s|^2 / (2 n.(q - s)) for a point q, the medial axis). The other is the way to the other's allowance. The
/// regions of two places are disjoint: if x were in both, each would be the nearer. They keep 1 mm apart, or a
/// fifth of the room if that is less, and never less than 0.05 mm; where the sew lines touch, the cut lines lie up
/// to 0.03 mm inside them.
class AllowanceFit {
  public:
    /// O(n log n) for n segments, if few of them are close to each other.
    explicit AllowanceFit(const SewContour& contour);

    /// True if the segment, its ends included, has nothing to meet.
    bool is_free(std::size_t segment) const { return near_[segment].empty(); }

    /// How far the cut line may lie from `place` along `direction`, at most `wanted` [m]. `direction` is a unit
    /// vector, perpendicular to the sew line, or between the two normals at a corner. O(#segments near).
    ReachLimit limit(const SewPlace& place, const Vec2& direction, double wanted) const;

  private:
    struct Facing {
        std::size_t segment;
        SewContour::Part part;
    };
    void find_near();

    const SewContour& contour_;
    std::vector<std::vector<std::size_t>> near_;  // for each segment, those whose allowances come near
    std::vector<std::vector<Vec2>> corners_;      // the area that the allowances cover around the start of each segment
};

/// The points of the allowances around the start of a segment, between the end of one and the start of the other,
/// both excluded; none if the corner turns inward. Bends within an edge are mitred.
std::vector<Vec2> points_round(const SewContour& contour, std::size_t segment, double reach_in, double reach_out);

}  // namespace ripstop
