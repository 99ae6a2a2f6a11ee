#pragma once

#include <limits>
#include <vector>

#include "ripstop/pattern/cut/sew_contour.h"

namespace ripstop {

/// How far the cut line may lie from a place of the sew line.
struct ReachLimit {
    double reach = 0;  ///< [m]
    int segment = -1;  ///< of the contour: what it meets; -1: nothing, the reach is what was asked for
    double gap = 0;    ///< the clear width to that [m]
};

/// Where a ball meets a part of a segment: its radius [m], infinite where it never does, and the place.
struct BallContact {
    double reach = std::numeric_limits<double>::infinity();
    Vec2 at = Vec2::Zero();
};

/// The ball that touches `from`, grows along `way` (unit) and first meets the part of the segment from its outside.
BallContact ball_contact(const Vec2& from, const Vec2& way, const SewSegment& segment, const SewContour::Part& part);

/// Shares the room between parts of a sew line that face each other, so that the cut line keeps the topology of the
/// sew line: no allowance runs over another that is apart from it (`SewContour::is_apart`), nor over the piece.
///
/// A point x at distance h from the place it belongs to may be cut with it unless it lies in the allowance of a part
/// that is apart and nearer. So both take half the gap g, or the narrower all of its own and the wider the rest:
///
///     h = min(a, max(g/2, g - b))        between parallel lines with allowances a and b
///
/// in general the ball that touches the sew line at the place (|q - s|^2 / (2 n.(q - s)) for a point q, the medial
/// axis) and the way to the other's allowance, whichever is longer. The regions that two places get are disjoint:
/// were x in both, each would be the nearer. They lie 1 mm apart, less where that were more than a fifth of the room,
/// and never less than 0.05 mm: where the sew lines touch, the cut lines run up to 0.03 mm within them.
class AllowanceFit {
  public:
    /// O(n log n) for n segments of which few lie near each other.
    explicit AllowanceFit(const SewContour& contour);

    /// Has the segment, its ends included, anything to meet?
    bool is_free(std::size_t segment) const { return near_[segment].empty(); }

    /// How far the cut line may run from `place` along `direction` (unit, at right angles to the sew line or, at a
    /// corner, between the two), at most `wanted` [m]. O(#segments near).
    ReachLimit limit(const SewPlace& place, const Vec2& direction, double wanted) const;

  private:
    struct Facing {
        std::size_t segment;
        SewContour::Part part;
    };
    void find_near();

    const SewContour& contour_;
    std::vector<std::vector<std::size_t>> near_;  // segments whose allowances come near, of each
    std::vector<std::vector<Vec2>> corners_;      // what the allowances cover round the start of each segment
};

/// The allowances round the start of a segment, from the end of the one to the start of the other, both left out;
/// none where it turns inward. Bends of an edge are mitred.
std::vector<Vec2> points_round(const SewContour& contour, std::size_t segment, double reach_in, double reach_out);

}  // namespace ripstop
