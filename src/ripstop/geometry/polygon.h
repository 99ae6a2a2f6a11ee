#pragma once

#include <array>
#include <vector>

#include "ripstop/geometry/types.h"

namespace ripstop {

// A polygon is its corners in order (#P x 2); the last is joined to the first, which is not repeated.

/// Area by the shoelace sum [m2], positive counter-clockwise. O(#P), as all here that say nothing else.
double signed_area(const Points2& polygon);

/// Centroid of the area inside [m]. Requires an area.
Vec2 area_centroid(const Points2& polygon);

/// Length of the outline, the closing edge included [m].
double perimeter(const Points2& polygon);

/// Does the outline go round `point` (winding number not zero)? A point exactly on the outline may count as either.
bool contains(const Points2& polygon, const Vec2& point);

/// Distance from `point` to the nearest point of the outline, never negative [m].
double distance_to_outline(const Points2& polygon, const Vec2& point);

/// How far from `point` along `way` (a unit vector) the outline is first met [m]; infinity where it never is.
double distance_along(const Points2& polygon, const Vec2& point, const Vec2& way);

/// A rectangle turned counter-clockwise by `turn` [rad]; `half` is half its width and height before the turn.
struct Box {
    Vec2 centre = Vec2::Zero();
    Vec2 half = Vec2::Zero();
    double turn = 0;
};

/// Does the whole box lie inside the polygon? Requires an outline that does not cross itself.
bool contains(const Points2& polygon, const Box& box);

/// Where the horizontal line at height `y` runs inside the polygon: intervals of x from left to right.
std::vector<std::array<double, 2>> horizontal_chords(const Points2& polygon, double y);

/// Places where an outline crosses or touches itself.
struct SelfIntersections {
    int count = 0;
    Vec2 first = Vec2::Zero();  ///< at the lowest-numbered edge concerned
};

/// The pairs of edges that meet other than as neighbours at their common corner: crossings, touches, overlaps, and
/// edges that fold back on the one before. A corner that lies on another edge or corner counts once. The decision is
/// exact (`orient2d`), the place is rounded. Corners repeated in a row count as one. Sweep along the longer side of the
/// bounding box: about O(#P log #P) for an outline of short edges, O(#P2) cheap box tests at worst.
SelfIntersections self_intersections(const Points2& polygon);

/// A circle in the plane [m].
struct Circle {
    Vec2 centre = Vec2::Zero();
    double radius = 0;
};

/// The largest circle inside the polygon, its radius within `precision` [m] of the best: its centre is the pole of
/// inaccessibility, where a label has the most room. Cells of a grid are split in four as long as they can beat the
/// best. O(#P) a cell, some hundred cells at a precision of a hundredth of the size. A polygon without inside gives
/// radius 0.
Circle largest_circle_inside(const Points2& polygon, double precision);

}  // namespace ripstop
