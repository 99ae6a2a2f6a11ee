#pragma once

#include <optional>
#include <vector>

#include "ripstop/mesh/triangle_mesh.h"

namespace ripstop {

/// The source of a vertex: on the edge from a to b of the whole mesh, at this fraction; a vertex of the whole has
/// a = b.
struct SplitVertex {
    int a = 0, b = 0;
    double share = 0;

    bool operator==(const SplitVertex& other) const = default;
};

/// One of the two halves of a cut mesh.
struct MeshHalf {
    TriangleMesh mesh;
    std::vector<SplitVertex> source;  ///< source of each vertex
    std::vector<int> boundary;        ///< boundary vertices in order, as by `require_disk`
    std::vector<int> cut;             ///< vertices on the cut, from its start to its end
};

/// The halves of a cut disk: left and right of the cut, as seen along it from outside.
struct MeshSplit {
    MeshHalf left, right;
};

/// Cuts a disk along the zero line of `field` (#V, linear in each triangle); the left half is where it is positive.
/// Triangles are split on the line, so the halves lie on the surface, their areas add up and both have the same
/// points on the cut, bit for bit. Where the line passes a vertex at less than `snap` of an edge, it goes through the
/// vertex: this avoids slivers, but the line is straight only to that fraction of an edge. Empty if the line does not
/// divide the disk into two. O(#F log #F).
std::optional<MeshSplit> split_mesh(const TriangleMesh& mesh, const Eigen::VectorXd& field, double snap = 0.03);

}  // namespace ripstop
