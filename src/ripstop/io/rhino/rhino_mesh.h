#pragma once

#include <string>

#include "ripstop/io/rhino/rhino_object.h"
#include "ripstop/mesh/triangle_mesh.h"

namespace ripstop {

struct RhinoMesh {
    TriangleMesh mesh;
    int faces_left_out = 0;  ///< with fewer than three different corners
    double rounding = 0;     ///< of vertices that the file has in single precision alone
    int joined = 0;          ///< vertices that were in one place with another
};

/// The surface of a mesh object: its vertices in double precision where the file has them so and they fit the single
/// ones, those that a face uses, in their order. A quad becomes two triangles that face one way, along its shorter
/// diagonal (the first where they are equal to 1e-6). Where the faces do not hang together (an unwelded mesh: each face
/// with vertices of its own), vertices in one place are made one if that leaves fewer parts.
///
/// `writer`: RhinoTables::writer. Throws InputError where the data is cut short, and naming the object (`called`) for
/// a face at a vertex that is not there and for coordinates that are not finite. O(#V log #V + #F).
RhinoMesh read_rhino_mesh(const RhinoClass& object, unsigned writer, const std::string& called);

}  // namespace ripstop
