#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "ripstop/model/tile/cad_model.h"

namespace ripstop {

/// Reads the surfaces and polylines of a Wavefront OBJ file: `v`, `vt`, `f`, `l`, `o`, `g` and `usemtl` records.
/// Skips all other records.
///
/// Surfaces. The faces with one name form one surface; surfaces are ordered by their first faces. A name that
/// comes back continues its surface; a name without faces gives none. An `o` starts an object and ends the group,
/// a `g` starts a group in the object. The name is that of the object or of the group, or `OBJECT/GROUP` if both
/// are set and differ. If no face has a name, each connected part is a surface: `STEM` if there is only one, else
/// `STEM_01`, `STEM_02`, …, where STEM is the file's name without its folder and `.obj`. If only some faces have
/// no name, those before the first name form one surface STEM.
///
/// Vertices. A surface has the vertices its faces use, in the file's order. Nothing is welded, because vertices in
/// one place may be the two sides of a closed dart. Polygons are fanned (`fan_corner`), from the first corner if
/// they are convex. Indices count from 1, or from the end if negative; a face may precede its vertices. Weights
/// and colours after x y z are skipped. `drawn` is set from `vt` if every corner has one and each vertex has only
/// one.
///
/// Polylines. Each `l` is a curve. It has the name that a face there would have, and the attribute `layer`: the
/// object, the group, or `OBJECT::GROUP`. A polyline that starts at the vertex where the one before it ends, under
/// the same name, continues it. A polyline with one point is left out with a remark.
///
/// Surfaces and curves given by equations (`surf`, `curv`) are listed in `unread`.
///
/// Material. The attribute `material` is the name that `usemtl` gives, if all faces of a surface have the same.
///
/// Throws InputError `NAME:LINE: what was found, what was expected, what to do` for a coordinate that is not
/// finite or not below 1e12, for an index without a vertex, for a face with fewer than three different corners,
/// and for a file without faces. Linear in the file's size in time and memory.
CadModel read_obj(std::istream& in, const std::string& name);

/// Writes each mesh as an object: `o`, `v`, `vt` if it is `drawn`, and `f` with 1-based indices over the whole
/// file. Each number is the shortest text that reads back as the same double, so reading returns equal meshes if
/// every vertex is used.
void write_obj(std::ostream& out, const std::vector<NamedMesh>& meshes);

/// Writes each curve as an object with one polyline: `o`, `v`, `l`. If the file also has a surface, `read_obj`
/// returns the same curves.
void write_obj_curves(std::ostream& out, const std::vector<NamedCurve>& curves);

}  // namespace ripstop
