#pragma once

#include <vector>

#include "ripstop/mesh/triangle_mesh.h"

namespace ripstop {

/// The connected component of each triangle (#F). Triangles that share a vertex are connected. Components are
/// numbered by their first triangle.
std::vector<int> connected_parts(const TriangleMesh& mesh);

}  // namespace ripstop
