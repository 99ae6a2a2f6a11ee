#pragma once

#include <vector>

#include "ripstop/mesh/triangle_mesh.h"

namespace ripstop {

/// A line drawn on the flat cloth, carried to the tile in space: the way back of `draw_lines`.
///
/// Each point goes where its triangle has it, and the line gets a point at every edge of the mesh it crosses, so it
/// lies in the surface. Where it leaves the cloth it ends, and begins again where it comes back (#P x 3 each, at least
/// 2 rows). `flat`: #V x 2, the tile on the cloth, no triangle without area. `line`: #points x 2. O(#points x #F).
std::vector<Points3> lift_line(const TriangleMesh& mesh, const Points2& flat, const Points2& line);

}  // namespace ripstop
