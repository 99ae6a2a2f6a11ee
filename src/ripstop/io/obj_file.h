#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ripstop/geometry/types.h"

namespace ripstop {

/// Indices from 0, as the file numbers its `v` and `vt`.
struct ObjCorner {
    int vertex;
    int texture;  ///< -1: none
};

struct ObjFace {
    std::size_t first;  ///< of its corners
    int count;
    int surface;
    long line;
};

/// What an OBJ file says, before any surface is made of it. Lengths in its own unit.
struct ObjFile {
    std::string name;
    std::vector<Vec3> vertices;
    std::vector<Vec2> textures;
    std::vector<ObjCorner> corners;
    std::vector<ObjFace> faces;
    std::vector<std::string> surfaces;
    bool named = false;  ///< whether any face has a name

    /// Throws InputError `NAME:LINE: what`.
    [[noreturn]] void refuse(long line, const std::string& what) const;
};

/// The records of an OBJ file, as `read_obj` describes them; every index holds and no face has a vertex twice. Throws
/// InputError.
ObjFile parse_obj(std::string_view text, const std::string& name);

}  // namespace ripstop
