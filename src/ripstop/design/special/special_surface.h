#pragma once

#include <array>
#include <vector>

#include "ripstop/design/special/special_body.h"
#include "ripstop/mesh/triangle_mesh.h"

namespace ripstop {

/// A closed triangulated surface that supports local edge operations. Half-edges as in `Adjacency`: 3 t + k runs from
/// corner k of triangle t to corner k + 1. Removed triangles and vertices keep their numbers and are skipped
/// (`is_triangle`). Each triangle knows its cell of the body and its tile, each half-edge its curve (-1: none).
class WorkSurface {
  public:
    /// Requires a closed, manifold, consistently oriented mesh.
    explicit WorkSurface(const TriangleMesh& mesh);

    int triangle_count() const { return static_cast<int>(corners_.size()); }
    int vertex_count() const { return static_cast<int>(position.size()); }
    int half_edge_count() const { return 3 * triangle_count(); }
    bool is_triangle(int t) const { return corners_[at(t)][0] >= 0; }
    bool is_vertex(int v) const { return leaving_[at(v)] >= 0; }
    /// Whether the half-edge represents its edge: one of the two halves does.
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

    /// Inserts a vertex on the edge and returns it; both parts of the edge stay on its curve.
    int split(int h, const Vec3& place);
    /// Replaces the edge by one between the two opposite vertices. Requires that they are not joined, and an edge on
    /// no curve.
    void flip(int h);
    /// Collapses the edge into the vertex it runs to. Requires `can_collapse`.
    void collapse(int h);
    /// Whether the surface stays manifold and no two curves merge.
    bool can_collapse(int h) const;

    std::vector<Vec3> position;
    std::vector<char> is_fixed;  ///< vertices that may not move
    std::vector<BodyCell> cell;  ///< cell of each triangle
    std::vector<int> tile;       ///< tile of each triangle

  private:
    static std::size_t at(int i) { return static_cast<std::size_t>(i); }

    /// The two triangles at a half-edge from a to b, t = (a, b, c) and u = (b, a, d).
    struct Diamond {
        int t, u, a, b, c, d;
        std::array<int, 4> outer;  ///< the outer half-edges bc, ca, ad and db of the neighbours
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
    std::vector<int> leaving_;  ///< one outgoing half-edge of each vertex; -1: removed
};

}  // namespace ripstop
