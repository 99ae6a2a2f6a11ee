#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "ripstop/model/tile/cad_model.h"

namespace ripstop {

/// The surfaces of an STL, ascii or binary. A file as long as its count of triangles asks for is binary, also where it
/// starts with `solid`.
///
/// Surfaces. STL knows triangles only: within a solid, corners in exactly one place are one vertex, in the order of
/// their first triangles, so that a closed dart is sewn shut, and each connected part is a surface. It is called after
/// its solid, `NAME` or `NAME_01`, `NAME_02`, …; a name that comes back goes on with its solid, one without a name is
/// called after the file, as all of a binary file is. Normals are skipped, and triangles with two corners in one place
/// are left out with a remark.
///
/// Throws InputError `NAME:LINE: …`, or `NAME: byte N: …` of a binary file, for what is no STL, is cut short or has
/// coordinates that are not finite and below 1e12, and where no triangle is left. Linear in time and memory.
CadModel read_stl(std::istream& in, const std::string& name);

/// Ascii, each surface a solid: the only STL that keeps tiles apart and their names. Numbers are the shortest that read
/// back as they were; readers in single precision round them to 7 digits. Neither shared vertices nor drawn positions
/// are kept.
void write_stl(std::ostream& out, const std::vector<NamedMesh>& meshes);

}  // namespace ripstop
