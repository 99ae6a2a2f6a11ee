#pragma once

#include <vector>

#include "ripstop/mesh/triangle_mesh.h"

namespace ripstop {

/// The number of the connected part each triangle belongs to (#F): parts share a vertex within, none between. Parts are
/// numbered by their first triangle.
std::vector<int> connected_parts(const TriangleMesh& mesh);

/// Only the given triangles, with the vertices they use in their old order; `kept` lists the old vertex of each new one.
struct Submesh {
    TriangleMesh mesh;
    std::vector<int> kept;
};
Submesh submesh(const TriangleMesh& mesh, const std::vector<int>& triangles);

}  // namespace ripstop
