#pragma once

#include <vector>

#include "ripstop/geometry/types.h"

namespace ripstop {

/// A polygon (#P x 2, corners in order, at least three) with its edges in rows by height, so that a question about a
/// point looks at few of them.
class IndexedOutline {
  public:
    /// O(#P).
    explicit IndexedOutline(const Points2& polygon);

    const Points2& points() const { return points_; }
    const Vec2& lower() const { return lower_; }
    const Vec2& upper() const { return upper_; }
    Vec2 corner(Eigen::Index i) const { return points_.row(i < points_.rows() ? i : 0); }

    /// As those of geometry/polygon.h: does it go round the point, and how far away is its line [m]?
    bool contains(const Vec2& point) const;
    double distance(const Vec2& point) const;
    bool is_near(const Vec2& point, double reach) const;

  private:
    std::size_t row_of(double y) const;

    Points2 points_;
    Vec2 lower_, upper_;
    double row_height_ = 0;
    std::vector<std::vector<Eigen::Index>> rows_;  // edges by the corner they begin at
};

/// How far a line reaches on one side of another, and where.
struct Reach {
    double distance = 0;  ///< [m]
    Vec2 at = Vec2::Zero();
};

/// How the areas of two outlines lie.
enum class Relation {
    apart,  ///< or touching
    crossing,
    within,  ///< the first in the second
    around,  ///< the second in the first
    same
};
struct OutlineRelation {
    Relation relation = Relation::apart;
    Reach overlap;  ///< where they cross: how deep the line of one reaches into the other
};

/// What reaches less than `tolerance` [m] beyond the other's line does not reach beyond it: pieces with a cut in common
/// touch. Every corner and every run between two crossings is looked at where they meet, one corner where they do not.
/// Requires outlines that do not cross themselves. About O(n log n) for n corners, and for those on the other's line
/// the corners near.
OutlineRelation relate(const IndexedOutline& first, const IndexedOutline& second, double tolerance);

/// The sides that two outlines have in common: their length [m], and where the first begins.
struct CommonSide {
    double length = 0;
    Vec2 at = Vec2::Zero();
};

/// What of the line of `first` lies within `tolerance` [m] of edges of `second` along its whole length. O(n log n) for
/// the n edges of both in the box that they share.
CommonSide common_side(const IndexedOutline& first, const IndexedOutline& second, double tolerance);

/// How far the line of `first` reaches out of `second`.
Reach reach_outside(const IndexedOutline& first, const IndexedOutline& second);

}  // namespace ripstop
