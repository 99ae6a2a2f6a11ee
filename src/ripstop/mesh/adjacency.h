#pragma once

#include <array>
#include <vector>

#include "ripstop/base/index.h"
#include "ripstop/geometry/types.h"

namespace ripstop {

/// Edge adjacency of triangles. Immutable, computed once from the triangles in O(#F log #F).
///
/// Half-edge h = 3 t + k runs from corner k to corner k + 1 (mod 3) of triangle t, so it lies opposite corner k + 2.
/// Any triangle list is accepted: where more than two triangles share an edge, or two run along it in the same
/// direction, their half-edges count as boundary and `irregular_edges` lists the edge.
class Adjacency {
  public:
    explicit Adjacency(const Triangles& triangles, int vertex_count);

    int half_edge_count() const { return static_cast<int>(twin_.size()); }
    int twin(int half_edge) const { return twin_[at(half_edge)]; }  ///< -1 at the boundary
    bool is_boundary(int half_edge) const { return twin(half_edge) < 0; }
    int from(int half_edge) const { return triangles_(half_edge / 3, half_edge % 3); }
    int to(int half_edge) const { return triangles_(half_edge / 3, (half_edge % 3 + 1) % 3); }
    int opposite(int half_edge) const { return triangles_(half_edge / 3, (half_edge % 3 + 2) % 3); }
    static int triangle(int half_edge) { return half_edge / 3; }
    static int next(int half_edge) { return half_edge / 3 * 3 + (half_edge % 3 + 1) % 3; }
    static int previous(int half_edge) { return half_edge / 3 * 3 + (half_edge % 3 + 2) % 3; }

    int vertex_count() const { return static_cast<int>(outgoing_start_.size()) - 1; }
    /// The half-edges that leave `vertex`, in increasing order: one per triangle at the vertex.
    std::vector<int> outgoing(int vertex) const;

    /// One half-edge per undirected edge (#E), in increasing order: the boundary half-edge or the smaller twin.
    const std::vector<int>& edges() const { return edges_; }

    /// The non-manifold or inconsistently oriented edges, as (from, to).
    const std::vector<std::array<int, 2>>& irregular_edges() const { return irregular_; }

  private:
    Triangles triangles_;
    std::vector<int> twin_;
    std::vector<int> edges_;
    std::vector<int> outgoing_start_;
    std::vector<int> outgoing_;
    std::vector<std::array<int, 2>> irregular_;
};

}  // namespace ripstop
