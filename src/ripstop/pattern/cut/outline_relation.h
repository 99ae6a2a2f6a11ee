#pragma once

#include <vector>

#include "ripstop/geometry/types.h"

namespace ripstop {

/// A polygon (#P x 2, corners in order, at least three) with its edges sorted into rows by height, so that a query
/// about a point tests few of them.
class IndexedOutline {
  public:
    /// O(#P).
    explicit IndexedOutline(const Points2& polygon);

    const Points2& points() const { return points_; }
    const Vec2& lower() const { return lower_; }
    const Vec2& upper() const { return upper_; }
    Vec2 corner(Eigen::Index i) const { return points_.row(i < points_.rows() ? i : 0); }

    /// As in geometry/polygon.h: whether the polygon contains the point, and the distance to its line [m].
    bool contains(const Vec2& point) const;
    double distance(const Vec2& point) const;
    bool is_near(const Vec2& point, double reach) const;

  private:
    std::size_t row_of(double y) const;

    Points2 points_;
    Vec2 lower_, upper_;
    double row_height_ = 0;
    std::vector<std::vector<Eigen::Index>> rows_;  // edges, by their first corner
};

/// How far a line protrudes on one side of another, and where.
struct Protrusion {
    double distance = 0;  ///< [m]
    Vec2 at = Vec2::Zero();
};

/// The relation of two areas.
enum class Relation {
    apart,  ///< or touching
    crossing,
    within,  ///< the first inside the second
    around,  ///< the second inside the first
    same
};
struct OutlineRelation {
    Relation relation = Relation::apart;
    Protrusion overlap;  ///< if they cross: how deep the line of one reaches into the other
};

/// The relation of two outlines that do not cross themselves. A protrusion of less than `tolerance` [m] beyond the
/// other's line is ignored, so pieces that share a cut touch. Where the outlines meet, tests every corner and
/// every part between two crossings; where they do not, one corner. About O(n log n) for n corners, and more if
/// many corners lie on the other's line.
OutlineRelation relate(const IndexedOutline& first, const IndexedOutline& second, double tolerance);

/// The sides that two outlines have in common: their total length [m], and where the first begins.
struct CommonSide {
    double length = 0;
    Vec2 at = Vec2::Zero();
};

/// The edges of `first` that lie within `tolerance` [m] of edges of `second` along their whole length. O(n log n)
/// for the n edges of both in their common box.
CommonSide common_side(const IndexedOutline& first, const IndexedOutline& second, double tolerance);

/// How far the line of `first` extends out of `second`.
Protrusion reach_outside(const IndexedOutline& first, const IndexedOutline& second);

}  // namespace ripstop
