#pragma once

#include <string>
#include <vector>

#include "ripstop/mesh/adjacency.h"
#include "ripstop/mesh/triangle_mesh.h"

namespace ripstop {

/// The boundary vertices of a disk in order, counter-clockwise seen from outside (the surface lies to the left); starts
/// at the lowest-numbered one.
///
/// A disk here is what can be laid flat in one piece: triangles with area, consistently oriented, edge- and
/// vertex-manifold, connected, with exactly one boundary loop and no handle (Euler number 1), every vertex used.
/// Throws InputError: `name`, what is wrong and where (coordinates in metres). O(#F log #F).
std::vector<int> require_disk(const TriangleMesh& mesh, const Adjacency& adjacency, const std::string& name);

/// Points of the boundary loops of any edge-manifold mesh, each loop counter-clockwise seen from outside.
std::vector<std::vector<int>> boundary_loops(const Adjacency& adjacency);

}  // namespace ripstop
