#pragma once

#include <vector>

#include "ripstop/mesh/triangle_mesh.h"

namespace ripstop {

/// The number of the connected part each triangle belongs to (#F): parts share a vertex within, none between. Parts are
/// numbered by their first triangle.
std::vector<int> connected_parts(const TriangleMesh& mesh);

}  // namespace ripstop
