#pragma once

#include <map>
#include <string>
#include <vector>

#include "ripstop/io/mesh/mesh_records.h"

namespace ripstop {

/// Removes corners that a face repeats at once (1 2 2 3) or returns to at once (1 2 1 3). Removes faces with fewer
/// than three corners left and adds a remark. Requires valid indices. Linear.
void mend_faces(MeshRecords& file);

/// Three corners for each triangle, and the face that each triangle comes from.
struct TriangleList {
    std::vector<std::size_t> corners;
    std::vector<std::size_t> faces;
    std::map<std::size_t, std::string> faults;  ///< of faces that cannot be fanned; they are fanned from corner 0
};

/// Fans every face into triangles (`fan_corner`). The choice of the fan ignores repeated corners in one place.
/// Triangles between such corners, and those of a polygon without area, have no area; `mend_mesh` deals with them.
TriangleList triangulated(const MeshRecords& file);

}  // namespace ripstop
