#pragma once

#include <array>
#include <vector>

#include "ripstop/design/special/special_body.h"
#include "ripstop/mesh/triangle_mesh.h"

namespace ripstop {

/// A closed triangulated surface that can be changed edge by edge. Half-edges as in `Adjacency`: 3 t + k runs from
/// corner k of triangle t to corner k + 1. Removed triangles and vertices keep their numbers and are passed over
/// (`is_triangle`). Each triangle knows its cell of the body and its tile, each half-edge the curve it is drawn on (-1:
/// none).
class WorkSurface {
  public:
    /// Requires a closed manifold mesh, consistently oriented.
    explicit WorkSurface(const TriangleMesh& mesh);

    int triangle_count() const { return static_cast<int>(corners_.size()); }
    int vertex_count() const { return static_cast<int>(position.size()); }
    int half_edge_count() const { return 3 * triangle_count(); }
    bool is_triangle(int t) const { return corners_[at(t)][0] >= 0; }
    bool is_vertex(int v) const { return leaving_[at(v)] >= 0; }
    /// Of the two halves of an edge the one that stands for it.
    bool is_edge(int h) const { return is_triangle(h / 3) && h < twin(h); }

    int corner(int t, int k) const { return corners_[at(t)][at(k)]; }
    Vec3 place(int t, int k) const { return position[at(corner(t, k))]; }
    int from(int h) const { return corner(h / 3, h % 3); }
    int to(int h) const { return corner(h / 3, (h % 3 + 1) % 3); }
    int opposite(int h) const { return corner(h / 3, (h % 3 + 2) % 3); }
    int twin(int h) const { return twins_[at(h)]; }
    static int next(int h) { return h / 3 * 3 + (h % 3 + 1) % 3; }
    static int previous(int h) { return h / 3 * 3 + (h % 3 + 2) % 3; }
    int curve(int h) const { return curves_[at(h)]; }
    void draw(int h, int curve);
    double length(int h) const { return (position[at(to(h))] - position[at(from(h))]).norm(); }

    /// The half-edges that leave a vertex, counter-clockwise.
    void leaving(int v, std::vector<int>& half_edges) const;
    bool joined(int a, int b) const;

    /// Puts a vertex on the edge; both halves of the edge stay on its curve. Returns the vertex.
    int split(int h, const Vec3& place);
    /// Joins the vertices opposite to the edge instead. Requires that they are not joined, and an edge on no curve.
    void flip(int h);
    /// Draws the vertex the edge comes from into the one it runs to. Requires `can_collapse`.
    void collapse(int h);
    /// Whether the surface stays a manifold and no two curves are drawn into one.
    bool can_collapse(int h) const;

    std::vector<Vec3> position;
    std::vector<char> is_fixed;  ///< vertices that may not move
    std::vector<BodyCell> cell;  ///< of triangles
    std::vector<int> tile;       ///< of triangles

  private:
    static std::size_t at(int i) { return static_cast<std::size_t>(i); }

    /// The two triangles at a half-edge from a to b, t = (a, b, c) and u = (b, a, d).
    struct Diamond {
        int t, u, a, b, c, d;
        std::array<int, 4> outer;  ///< the half-edges on the far side of bc, ca, ad and db
        std::array<int, 4> on;     ///< their curves
    };
    enum Side : std::size_t { bc, ca, ad, db };
    Diamond around(int h) const;

    int add_triangle(int like, int a, int b, int c);
    void set(int t, int a, int b, int c);
    void pair(int h, int g, int curve);

    std::vector<std::array<int, 3>> corners_;
    std::vector<int> twins_;
    std::vector<int> curves_;
    std::vector<int> leaving_;  ///< of each vertex one half-edge; -1: removed
};

}  // namespace ripstop
