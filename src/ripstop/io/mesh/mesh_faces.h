#pragma once

#include <map>
#include <string>
#include <vector>

#include "ripstop/io/mesh/mesh_records.h"

namespace ripstop {

/// Takes corners out that a face names several times in a row (1 2 2 3) or comes back from at once (1 2 1 3), and faces
/// with fewer than three left, with a remark. Requires indices that hold. Linear.
void mend_faces(MeshRecords& file);

/// The corners of all triangles, three a triangle, and the face each triangle comes from.
struct TriangleList {
    std::vector<std::size_t> corners;
    std::vector<std::size_t> faces;
    std::map<std::size_t, std::string> faults;  ///< of faces that cannot be fanned: fanned from corner 0 all the same
};

/// Faces as fans of triangles (`fan_corner`). Corners in one place count once there: the triangles between them, and
/// those of a polygon without area, have no area either and are left to `mend_mesh`.
TriangleList triangulated(const MeshRecords& file);

}  // namespace ripstop
