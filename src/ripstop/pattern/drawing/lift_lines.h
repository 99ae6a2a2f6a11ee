#pragma once

#include <vector>

#include "ripstop/mesh/triangle_mesh.h"

namespace ripstop {

/// Maps a line drawn on the flat cloth to the tile in space; the inverse of `draw_lines`.
///
/// Each point is mapped by its triangle. The line gets a point at every mesh edge it crosses, so it lies in the
/// surface. Where it leaves the cloth it ends, and it starts again where it returns (#P x 3 each, at least 2
/// rows). `flat` is #V x 2, the tile on the cloth, without degenerate triangles. `line` is #points x 2. O(#points
/// x #F).
std::vector<Points3> lift_line(const TriangleMesh& mesh, const Points2& flat, const Points2& line);

}  // namespace ripstop
