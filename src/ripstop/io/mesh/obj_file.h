#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ripstop/io/mesh/mesh_records.h"

namespace ripstop {

/// A polyline of the file: indices from 0 into its vertices.
struct ObjCurve {
    std::string name;
    std::string layer;  ///< `OBJECT::GROUP`, or what there is of them
    std::vector<int> vertices;
    long line;  ///< where it starts
};

/// What an OBJ file says, before any surface is made of it.
struct ObjFile {
    MeshRecords mesh;
    std::vector<ObjCurve> curves = {};
    std::vector<UnreadObject> unread = {};
    std::vector<std::string> remarks = {};
};

/// The records of an OBJ file, as `read_obj` describes them; the indices of curves hold. Throws InputError.
ObjFile parse_obj(std::string_view text, const std::string& name);

}  // namespace ripstop
