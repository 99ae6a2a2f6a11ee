#pragma once

#include <array>
#include <functional>
#include <vector>

#include "ripstop/geometry/types.h"

namespace ripstop::cad {

/// A triangulation of a plane of parameters. Triangles turn left; each knows its neighbours.
///
/// Every operation keeps all triangles turning left, by the exact predicate `orient2d`. So the result is a
/// triangulation, whatever lengths and angles decide.
class UvMesh {
  public:
    /// Starts with one triangle far around a box with this centre and size; its corners are the nodes 0, 1, 2.
    UvMesh(const Vec2& middle, double reach);

    struct Side {
        int triangle = -1, corner = 0;  ///< the side is opposite this corner
    };

    int add(const Vec2& at);  ///< adds a node that is in no triangle yet
    void drop_last();         ///< removes the last node, which must be in no triangle

    /// Inserts a node at its place, into the triangle or onto the side there. Returns the node that was already
    /// there, else the node itself.
    int insert(int node);
    /// Inserts a node into a side; it may lie anywhere between the side's ends. False if a triangle would not turn
    /// left.
    bool split(const Side& side, int node);
    bool flip(const Side& side);  ///< false if the triangles form no convex quadrilateral or the side is fixed

    /// Makes a -> b a side and fixes it. False if another fixed side or a node is in the way.
    bool fix(int a, int b);
    /// Removes everything outside of the closed lines of fixed sides.
    void keep_inside();

    /// Flips sides while `wants` asks for it, starting with those of the `changed` triangles. Returns all
    /// triangles that it touched.
    std::vector<int> settle(const std::function<bool(const Side&)>& wants);
    std::vector<int> settle_all(const std::function<bool(const Side&)>& wants);  ///< starting with all triangles

    std::array<int, 2> ends(const Side& side) const;  ///< in the direction of the side's triangle
    Side across(const Side& side) const;              ///< the neighbour's view of the side; triangle -1: none
    bool is_fixed(const Side& side) const { return fixed_[index(side.triangle)][index(side.corner)]; }
    Side side_of(int a, int b) const;         ///< the side from a to b in its triangle; triangle -1 if there is none
    std::vector<int> around(int node) const;  ///< the triangles of a node that is not on a border
    bool turns_left(int triangle) const;
    bool is_here(int triangle) const { return corners_[index(triangle)][0] >= 0; }

    int triangle_count() const { return static_cast<int>(corners_.size()); }
    const std::array<int, 3>& corners(int triangle) const { return corners_[index(triangle)]; }

    std::vector<Vec2> at;  ///< the places of the nodes

  private:
    static std::size_t index(int i) { return static_cast<std::size_t>(i); }
    int find(int a, int b) const;
    int place(const std::array<int, 3>& corners, int triangle);
    void join(const Side& a, const Side& b);
    Side left_at(int triangle, const Vec2& p) const;
    void split_triangle(int triangle, int node);
    std::vector<Side> crossed(int a, int b) const;

    std::vector<std::array<int, 3>> corners_;
    std::vector<std::array<Side, 3>> beside_;
    std::vector<std::array<bool, 3>> fixed_;
    std::vector<int> some_;     ///< one triangle of each node
    std::vector<int> changed_;  ///< triangles that changed since the last `settle`
    mutable int last_ = 0;
};

}  // namespace ripstop::cad
