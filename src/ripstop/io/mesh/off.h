#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "ripstop/model/tile/cad_model.h"

namespace ripstop {

/// Reads the surfaces of a Geomview OFF file. The keyword `[ST][C][N]OFF` may be missing, and the counts may stand
/// on its line. Each vertex and each face is a line; `#` starts a comment. Also reads `OFF BINARY`, which is big
/// endian. Skips normals and colours. The last two numbers of an `ST` vertex are its flat position (`drawn`).
/// Refuses points in four or n dimensions (`4OFF`, `nOFF`).
///
/// Each connected part is a surface: `STEM` if there is only one, else `STEM_01`, `STEM_02`, …. Nothing is welded,
/// vertices without a face are dropped, polygons are fanned (`fan_corner`), and indices count from 0.
///
/// Throws InputError `NAME:LINE: …`, or `NAME: byte N: …` for a binary file, for counts beyond what the file
/// holds, for a coordinate that is not finite or not below 1e12, and for faces as `make_surfaces` does. Linear in
/// the file's size in time and memory, whatever the counts say.
CadModel read_off(std::istream& in, const std::string& name);

/// Writes all meshes as one text OFF, or as STOFF if all have drawn positions. Each number is the shortest text
/// that reads back as the same double. Names are lost. So are the bounds of meshes that share vertices or are not
/// connected.
void write_off(std::ostream& out, const std::vector<NamedMesh>& meshes);

}  // namespace ripstop
