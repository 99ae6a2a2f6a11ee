#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ripstop/io/mesh/mesh_records.h"

namespace ripstop {

/// A polyline of the file, as indices from 0 into its vertices.
struct ObjCurve {
    std::string name;
    std::string layer;  ///< `OBJECT::GROUP`, or whichever of them is set
    std::vector<int> vertices;
    long line;  ///< where it starts
};

/// The contents of an OBJ file, before surfaces are made.
struct ObjFile {
    MeshRecords mesh;
    std::vector<ObjCurve> curves = {};
    std::vector<UnreadObject> unread = {};
    std::vector<std::string> remarks = {};
};

/// Parses the records of an OBJ file, as `read_obj` describes them. The indices of curves are valid. Throws
/// InputError.
ObjFile parse_obj(std::string_view text, const std::string& name);

}  // namespace ripstop
