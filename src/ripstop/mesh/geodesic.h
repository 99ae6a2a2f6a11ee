#pragma once

#include <array>
#include <vector>

#include "ripstop/mesh/adjacency.h"
#include "ripstop/mesh/triangle_mesh.h"

namespace ripstop {

/// A point of the surface: a triangle and where it lies in it, in the frame of the triangle laid flat (`lay_flat`:
/// corner 0 at the origin, corner 1 on +x) [m].
struct SurfacePoint {
    int triangle = 0;
    Vec2 local = Vec2::Zero();
};

/// A turn and a shift of the plane.
struct PlaneMotion {
    Vec2 turn = Vec2::UnitX();  ///< cosine and sine
    Vec2 shift = Vec2::Zero();

    Vec2 turned(const Vec2& v) const {
        return {turn.x() * v.x() - turn.y() * v.y(), turn.y() * v.x() + turn.x() * v.y()};
    }
    Vec2 operator()(const Vec2& p) const { return turned(p) + shift; }
    PlaneMotion after(const PlaneMotion& first) const { return {turned(first.turn), (*this)(first.shift)}; }
};

/// Where a straight walk ended and which way it was going there, so that it can be continued.
struct Walk {
    SurfacePoint end;
    Vec2 direction = Vec2::UnitX();  ///< unit length, in the frame of the end's triangle
    double walked = 0;               ///< [m]
    bool hit_boundary = false;       ///< stopped before its length, at the boundary
};

/// A triangle as it is seen from a point along straight lines on the surface: unfolded into the frame of the point's
/// triangle, and between which two rays it is seen.
struct Sight {
    int triangle = 0;
    int corner = -1;       ///< the corner opposite the edge it is seen through; -1: the triangle the viewer stands in
    PlaneMotion unfolded;  ///< from the triangle's frame to the viewer's
    Vec2 eye;              ///< where the viewer looks from
    std::array<Vec2, 2> between = {Vec2::Zero(), Vec2::Zero()};  ///< rays from the eye, right and left

    /// How far `point`, given in the viewer's frame, lies outside the rays: the sine of the angle, 0 between them.
    double hidden_by(const Vec2& point) const;
};

/// A disk's triangles laid flat, each in its own frame, with the motion from each to its neighbours: straight lines on
/// the surface are straight lines in the plane of the triangles unfolded one after the other. Everything here is
/// intrinsic, so sharp folds do no harm. Built once in O(#F log #F).
class UnfoldedSurface {
  public:
    /// Requires triangles with area and an edge-manifold mesh (`require_disk`).
    explicit UnfoldedSurface(const TriangleMesh& mesh);

    int triangle_count() const { return static_cast<int>(frames_.size()); }
    Vec3 position(const SurfacePoint& point) const;
    SurfacePoint at(int triangle, const Vec3& barycentric) const;
    Vec3 barycentric(const SurfacePoint& point) const;
    /// A corner in the triangle's frame.
    const Vec2& corner(int triangle, int k) const { return frame(triangle).corners[static_cast<std::size_t>(k)]; }
    /// The part of a direction in space along the triangle, in its frame.
    Vec2 along(int triangle, const Vec3& direction) const;
    /// The point of the surface nearest to a point in space; among equals the lowest triangle. O(#F).
    SurfacePoint nearest(const Vec3& point) const;

    /// Goes straight on from `from` along `direction` (any length but zero, in the frame of its triangle) for `length`:
    /// the straightest geodesic, each triangle unfolded across the edge it is left by. Stops at the boundary. Through a
    /// vertex it goes on in the triangles on one side of it, always the same for the same walk, and keeps its angle to
    /// that side; along an edge it stays on it. Cost: the triangles crossed.
    Walk walk(const SurfacePoint& from, const Vec2& direction, double length) const;

    /// Every triangle that straight lines from `from` of at most `radius` reach, nearer ones before those behind them.
    ///
    /// This is the logarithm of the surface about a point, exact, for all its neighbours in one go:
    /// `unfolded(p) - from.local` is the direction and the straight distance to the point p of the triangle, provided
    /// `hidden_by` is 0. A triangle is listed once for each gap it is seen through; on a flat surface a point of it
    /// lies in one of them, on a curved one it may be seen round both sides of a vertex, or not at all. Cost: the
    /// triangles seen.
    std::vector<Sight> look_around(const SurfacePoint& from, double radius) const;

  private:
    struct Frame {
        std::array<Vec2, 3> corners;
        std::array<Vec2, 3> outward;        ///< unit normal of edge k, from corner k to k + 1
        std::array<double, 3> offset;       ///< outward . x on the edge
        std::array<int, 3> twin;            ///< half-edge across; -1 at the boundary
        std::array<PlaneMotion, 3> across;  ///< from this frame to the neighbour's
        Vec3 origin, x_axis, y_axis;
    };
    const Frame& frame(int triangle) const { return frames_[static_cast<std::size_t>(triangle)]; }

    std::vector<Frame> frames_;
};

}  // namespace ripstop
