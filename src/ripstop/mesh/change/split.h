#pragma once

#include <optional>
#include <vector>

#include "ripstop/mesh/triangle_mesh.h"

namespace ripstop {

/// Where a vertex of a half comes from: on the edge from a to b of the whole, at this share of it; a vertex of the
/// whole has a = b.
struct SplitVertex {
    int a = 0, b = 0;
    double share = 0;

    bool operator==(const SplitVertex& other) const = default;
};

/// One of the two parts that a cut leaves.
struct MeshHalf {
    TriangleMesh mesh;
    std::vector<SplitVertex> source;  ///< of each vertex
    std::vector<int> boundary;        ///< as `require_disk` gives it
    std::vector<int> cut;             ///< its vertices on the cut, from the cut's start to its end
};

/// A disk cut in two: left of the cut, looking along it from outside, and right of it.
struct MeshSplit {
    MeshHalf left, right;
};

/// Cuts a disk along the line where `field` (#V, linear within triangles) is zero; the left half is where it is
/// positive. Triangles are split on the line, so the halves lie on the whole, their areas add up to its own and both
/// have the same points on the cut, bit for bit. Where the line passes a vertex at less than `snap` of an edge it goes
/// through it: no slivers, at the price of a line that is straight only to that share of an edge. Nothing where the
/// line does not divide the disk into two. O(#F log #F).
std::optional<MeshSplit> split_mesh(const TriangleMesh& mesh, const Eigen::VectorXd& field, double snap = 0.03);

}  // namespace ripstop
