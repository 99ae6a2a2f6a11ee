#pragma once

#include <array>
#include <vector>

#include "ripstop/mesh/adjacency.h"
#include "ripstop/mesh/triangle_mesh.h"

namespace ripstop {

/// A point of the surface: a triangle and local coordinates in its frame (`lay_flat`: corner 0 at the origin, corner
/// 1 on +x) [m].
struct SurfacePoint {
    int triangle = 0;
    Vec2 local = Vec2::Zero();
};

/// A rigid motion of the plane: a rotation and a translation.
struct PlaneMotion {
    Vec2 turn = Vec2::UnitX();  ///< cosine and sine of the rotation
    Vec2 shift = Vec2::Zero();

    Vec2 turned(const Vec2& v) const {
        return {turn.x() * v.x() - turn.y() * v.y(), turn.y() * v.x() + turn.x() * v.y()};
    }
    Vec2 operator()(const Vec2& p) const { return turned(p) + shift; }
    PlaneMotion after(const PlaneMotion& first) const { return {turned(first.turn), (*this)(first.shift)}; }
};

/// The end point and end direction of a straight walk, from which it can be continued.
struct Walk {
    SurfacePoint end;
    Vec2 direction = Vec2::UnitX();  ///< unit length, in the frame of the end's triangle
    double walked = 0;               ///< length walked [m]
    bool hit_boundary = false;       ///< the walk ended early, at the boundary
};

/// A triangle as seen from a point along straight lines on the surface: its motion into the frame of the viewer's
/// triangle and the two rays between which it is visible.
struct Sight {
    int triangle = 0;
    int corner = -1;       ///< the corner opposite the edge it is seen through; -1: the viewer's own triangle
    PlaneMotion unfolded;  ///< from the triangle's frame to the viewer's frame
    Vec2 eye;              ///< the viewer's position
    std::array<Vec2, 2> between = {Vec2::Zero(), Vec2::Zero()};  ///< right and left ray from the eye

    /// The sine of the angle by which `point`, in the viewer's frame, lies outside the rays; 0 between them.
    double hidden_by(const Vec2& point) const;
};

/// The triangles of a disk laid flat, each in its own frame, with the motions to its neighbours' frames. A straight
/// line on the surface is a straight line in the plane of the triangles unfolded in sequence. The data are intrinsic,
/// so sharp folds do no harm. Built once in O(#F log #F).
class UnfoldedSurface {
  public:
    /// Requires triangles with area and an edge-manifold mesh (`require_disk`).
    explicit UnfoldedSurface(const TriangleMesh& mesh);

    int triangle_count() const { return static_cast<int>(frames_.size()); }
    Vec3 position(const SurfacePoint& point) const;
    SurfacePoint at(int triangle, const Vec3& barycentric) const;
    Vec3 barycentric(const SurfacePoint& point) const;
    /// Corner k in the triangle's frame.
    const Vec2& corner(int triangle, int k) const { return frame(triangle).corners[static_cast<std::size_t>(k)]; }
    /// The tangential part of a direction in space, in the triangle's frame.
    Vec2 along(int triangle, const Vec3& direction) const;
    /// The point of the surface nearest to a point in space; if several are equally near, that of the lowest
    /// triangle. O(#F).
    SurfacePoint nearest(const Vec3& point) const;

    /// Walks the straightest geodesic from `from` along `direction` (any non-zero length, in the frame of its
    /// triangle) for `length` [m], unfolding each triangle across the edge it leaves by. Stops at the boundary.
    /// Through a vertex it continues on one side, the same for the same walk, and keeps its angle to that side; along
    /// an edge it stays on it. Cost: the number of triangles crossed.
    Walk walk(const SurfacePoint& from, const Vec2& direction, double length) const;

    /// Returns every triangle that straight lines of at most `radius` from `from` reach, nearer ones before those
    /// behind them.
    ///
    /// This is the exact logarithmic map of the surface at a point, for all neighbours at once:
    /// `unfolded(p) - from.local` is the direction and straight distance to the point p of the triangle, provided
    /// `hidden_by` is 0. A triangle is listed once for each gap through which it is visible. On a flat surface each
    /// of its points lies in one gap; on a curved surface a point may be visible round both sides of a vertex, or not
    /// at all. Cost: the number of triangles seen.
    std::vector<Sight> look_around(const SurfacePoint& from, double radius) const;

  private:
    struct Frame {
        std::array<Vec2, 3> corners;
        std::array<Vec2, 3> outward;        ///< unit normal of edge k, from corner k to k + 1
        std::array<double, 3> offset;       ///< outward . x on the edge
        std::array<int, 3> twin;            ///< the half-edge across; -1 at the boundary
        std::array<PlaneMotion, 3> across;  ///< from this frame to the neighbour's frame
        Vec3 origin, x_axis, y_axis;
    };
    const Frame& frame(int triangle) const { return frames_[static_cast<std::size_t>(triangle)]; }

    std::vector<Frame> frames_;
};

}  // namespace ripstop
