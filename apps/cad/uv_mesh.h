#pragma once

#include <array>
#include <functional>
#include <vector>

#include "ripstop/geometry/types.h"

namespace ripstop::cad {

/// Triangles in a plane of parameters. Triangles turn to the left; each knows its neighbours.
///
/// What is done to them keeps every triangle turning to the left, by `orient2d`, which is never wrong: so whatever
/// lengths and angles decide, the result is a triangulation.
class UvMesh {
  public:
    /// One triangle far around the box of these corners, `reach` the size of that box; its corners are the nodes 0, 1,
    /// 2.
    UvMesh(const Vec2& middle, double reach);

    struct Side {
        int triangle = -1, corner = 0;  ///< the side is opposite this corner
    };

    int add(const Vec2& at);  ///< a node in no triangle yet
    void drop_last();         ///< the last one, if it is in no triangle

    /// Puts a node where it stands, into the triangle or onto the side there. Gives the node that stood there before
    /// it, else the node itself.
    int insert(int node);
    /// Puts a node onto a side, wherever that is between the side's ends. False where a triangle would not turn to the
    /// left.
    bool split(const Side& side, int node);
    bool flip(const Side& side);  ///< false where the two triangles make no convex quadrilateral, or the side is fixed

    /// Makes a -> b a side and fixes it. False where another fixed side or a node is in the way.
    bool fix(int a, int b);
    /// Takes away what lies outside of the closed lines of fixed sides.
    void keep_inside();

    /// Flips sides, those of the triangles `changed` first, while `wants` asks for it; gives all triangles that were
    /// touched.
    std::vector<int> settle(const std::function<bool(const Side&)>& wants);
    std::vector<int> settle_all(const std::function<bool(const Side&)>& wants);  ///< beginning at all triangles

    std::array<int, 2> ends(const Side& side) const;  ///< as the side's triangle turns
    Side across(const Side& side) const;              ///< the same side of the neighbour; triangle -1: there is none
    bool is_fixed(const Side& side) const { return fixed_[index(side.triangle)][index(side.corner)]; }
    Side side_of(int a, int b) const;         ///< from a to b in its triangle; triangle -1: there is none
    std::vector<int> around(int node) const;  ///< the triangles of a node that is not on a border
    bool turns_left(int triangle) const;
    bool is_here(int triangle) const { return corners_[index(triangle)][0] >= 0; }

    int triangle_count() const { return static_cast<int>(corners_.size()); }
    const std::array<int, 3>& corners(int triangle) const { return corners_[index(triangle)]; }

    std::vector<Vec2> at;  ///< the nodes

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
    std::vector<int> some_;     ///< a triangle of each node
    std::vector<int> changed_;  ///< triangles made or altered since they were settled
    mutable int last_ = 0;
};

}  // namespace ripstop::cad
