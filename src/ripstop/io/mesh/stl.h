#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "ripstop/model/tile/cad_model.h"

namespace ripstop {

/// Reads the surfaces of an STL file, ascii or binary. A file is binary if its length matches its count of
/// triangles, even if it starts with `solid`.
///
/// Surfaces. STL has triangles only. Within a solid, corners in exactly the same place become one vertex, so a
/// closed dart is sewn shut; vertices are ordered by their first triangles. Each connected part is a surface,
/// called after its solid: `NAME`, or `NAME_01`, `NAME_02`, …. A name that comes back continues its solid. A solid
/// without a name is called after the file, and so is all of a binary file. Normals are skipped. Triangles with
/// two corners in one place are left out with a remark.
///
/// Throws InputError `NAME:LINE: …`, or `NAME: byte N: …` for a binary file, for a file that is not STL or is cut
/// short, for a coordinate that is not finite or not below 1e12, and for a file that leaves no triangle. Linear in
/// time and memory.
CadModel read_stl(std::istream& in, const std::string& name);

/// Writes ascii, with each surface as a solid: only this form of STL keeps tiles apart and named. Each number is
/// the shortest text that reads back as the same double; readers in single precision round it to 7 digits. Shared
/// vertices and drawn positions are lost.
void write_stl(std::ostream& out, const std::vector<NamedMesh>& meshes);

}  // namespace ripstop
