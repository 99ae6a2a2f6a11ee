#pragma once

#include <string>

#include "ripstop/io/rhino/rhino_object.h"
#include "ripstop/mesh/triangle_mesh.h"

namespace ripstop {

struct RhinoMesh {
    TriangleMesh mesh;
    int faces_left_out = 0;  ///< faces with fewer than three different corners
    double rounding = 0;     ///< rounding error of vertices that the file has in single precision only
    int joined = 0;          ///< number of vertices merged with another in the same place
};

/// The surface of a mesh object. Its vertices are those that a face uses, in their order. They are in double
/// precision if the file has double vertices that match the single ones. A quad becomes two triangles that face
/// the same way, split along the shorter diagonal, or along the first if both are equal to 1e-6. If the faces are
/// not connected (an unwelded mesh, in which each face has its own vertices), vertices in one place are merged if
/// that reduces the number of parts.
///
/// `writer` is RhinoTables::writer. Throws InputError if the data is cut short. Throws InputError with the
/// object's name (`called`) for an index without a vertex and for coordinates that are not finite. O(#V log #V +
/// #F).
RhinoMesh read_rhino_mesh(const RhinoClass& object, unsigned writer, const std::string& called);

}  // namespace ripstop
