#pragma once

#include <array>
#include <vector>

#include "ripstop/geometry/types.h"

namespace ripstop {

// A polygon is its corners in order (#P x 2). An edge joins the last to the first, which is not repeated.

/// Area by the shoelace formula [m2], positive if counter-clockwise. Functions here take O(#P) unless they say
/// otherwise.
double signed_area(const Points2& polygon);

/// Centroid of the enclosed area [m]. Requires a non-zero area.
Vec2 area_centroid(const Points2& polygon);

/// Length of the outline, the closing edge included [m].
double perimeter(const Points2& polygon);

/// Whether the outline winds round `point` (non-zero winding number). A point on the outline may count as either.
bool contains(const Points2& polygon, const Vec2& point);

/// Distance from `point` to the nearest point of the outline, never negative [m].
double distance_to_outline(const Points2& polygon, const Vec2& point);

/// Distance from `point` along `way` (a unit vector) to the first hit with the outline [m]; infinity if there is
/// none.
double distance_along(const Points2& polygon, const Vec2& point, const Vec2& way);

/// A rectangle rotated counter-clockwise by `turn` [rad]; `half` is half its width and height before the rotation.
struct Box {
    Vec2 centre = Vec2::Zero();
    Vec2 half = Vec2::Zero();
    double turn = 0;
};

/// Whether the whole box lies inside the polygon. Requires an outline that does not cross itself.
bool contains(const Points2& polygon, const Box& box);

/// The intervals of x in which the horizontal line at height `y` lies inside the polygon, from left to right.
std::vector<std::array<double, 2>> horizontal_chords(const Points2& polygon, double y);

/// Places where an outline crosses or touches itself.
struct SelfIntersections {
    int count = 0;
    Vec2 first = Vec2::Zero();  ///< place on the lowest-numbered edge involved
};

/// Finds the pairs of edges that meet other than as neighbours at their common corner: crossings, touches, overlaps,
/// and edges that fold back on the previous one. A corner that lies on another edge or corner counts once. The test
/// is exact (`orient2d`); the place is rounded. Repeated corners in a row count as one. Sweeps along the longer side
/// of the bounding box: about O(#P log #P) for an outline of short edges, O(#P2) cheap box tests at worst.
SelfIntersections self_intersections(const Points2& polygon);

/// A circle in the plane [m].
struct Circle {
    Vec2 centre = Vec2::Zero();
    double radius = 0;
};

/// The largest circle inside the polygon; its radius is within `precision` [m] of the optimum. Its centre is the pole
/// of inaccessibility, where a label has the most room. Grid cells are split in four as long as they can beat the
/// best. O(#P) per cell, some hundred cells at a precision of a hundredth of the size. Returns radius 0 if the
/// polygon has no interior.
Circle largest_circle_inside(const Points2& polygon, double precision);

}  // namespace ripstop
