#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "ripstop/model/tile/cad_model.h"

namespace ripstop {

/// The surfaces of a Geomview OFF: the keyword `[ST][C][N]OFF` or none, with or without the counts behind it, a vertex
/// and a face a line, `#` comments; also `OFF BINARY`, big endian. Normals and colours are skipped; the last two
/// numbers of an `ST` vertex are its flat position (`drawn`). Points in four or n dimensions (`4OFF`, `nOFF`) are
/// refused.
///
/// Each connected part is a surface: `STEM` where there is one, else `STEM_01`, `STEM_02`, …. Nothing is welded,
/// vertices without a face are dropped, polygons fanned (`fan_corner`), indices count from 0.
///
/// Throws InputError `NAME:LINE: …`, or `NAME: byte N: …` in a binary file, for counts the file does not hold,
/// coordinates that are not finite and below 1e12, and faces as `make_surfaces`. Linear in time and memory, whatever
/// the counts.
CadModel read_off(std::istream& in, const std::string& name);

/// All meshes in one OFF as text, or STOFF where all have drawn positions; numbers are the shortest that read back as
/// they were. Names are not kept, nor the bounds of meshes that hold together by shared vertices or fall apart.
void write_off(std::ostream& out, const std::vector<NamedMesh>& meshes);

}  // namespace ripstop
