#pragma once

#include <string>
#include <vector>

#include "ripstop/mesh/adjacency.h"
#include "ripstop/mesh/triangle_mesh.h"

namespace ripstop {

/// Returns the boundary vertices of a disk in order, counter-clockwise seen from outside (the surface lies to the
/// left), from the lowest-numbered one on.
///
/// A disk can be laid flat in one piece: its triangles have area, are consistently oriented, edge- and
/// vertex-manifold and connected, with exactly one boundary loop, no handle (Euler number 1) and no unused vertex.
/// Throws InputError that names `name`, the fault and its place (coordinates in metres). O(#F log #F).
std::vector<int> require_disk(const TriangleMesh& mesh, const Adjacency& adjacency, const std::string& name);

/// The boundary loops of an edge-manifold mesh as vertex numbers, each counter-clockwise seen from outside.
std::vector<std::vector<int>> boundary_loops(const Adjacency& adjacency);

}  // namespace ripstop
