#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "ripstop/model/tile/cad_model.h"

namespace ripstop {

/// The surfaces and polylines of a Wavefront OBJ: `v`, `vt`, `f`, `l`, `o`, `g` and `usemtl` records; everything else
/// is skipped.
///
/// Surfaces. The faces under one name are one surface, in the order of their first faces; a name that comes back goes
/// on with its surface, and a name without faces is none. An `o` starts an object without group, a `g` a group in the
/// object; the name is that of the object or of the group, `OBJECT/GROUP` where both are given and differ. A file in
/// which no face has a name gives one surface for each connected part: `STEM` where there is one, else `STEM_01`,
/// `STEM_02`, …, with STEM the file's name without folder and `.obj`; faces before the first name are one surface STEM.
///
/// Vertices. A surface has the vertices its faces use, in the file's order, and nothing is welded: vertices in one
/// place may be the two sides of a closed dart. Polygons are fanned (`fan_corner`): from the first corner where convex.
/// Indices count from 1, or from the end where negative; a face may come before its vertices. Weights and colours
/// behind x y z are skipped. `drawn` is filled from `vt` where every corner has one and each vertex has one alone.
///
/// Polylines. Each `l` is a curve with the name a face there would have and the attribute `layer`: the object, the
/// group, or `OBJECT::GROUP`. One that starts at the vertex where the one before it ends, under the same name, goes on
/// with it; one with a single point is left out with a remark.
///
/// What is given by equations (`surf`, `curv`) is named in `unread`.
///
/// Material. What `usemtl` says, as the attribute `material`, where all faces of a surface have the same.
///
/// Throws InputError `NAME:LINE: what was found, what was expected, what to do` for anything but finite coordinates
/// below 1e12, indices that hold and faces of three or more different corners, and where there is no face at all.
/// Linear in the file's size in time and memory.
CadModel read_obj(std::istream& in, const std::string& name);

/// Each mesh as an object: `o`, `v`, `vt` where `drawn`, `f` with 1-based indices over the whole file. Numbers are
/// the shortest that read back as they were, so that reading gives equal meshes where every vertex is used.
void write_obj(std::ostream& out, const std::vector<NamedMesh>& meshes);

/// Each curve as an object of one polyline: `o`, `v`, `l`. `read_obj` gives the same curves beside a surface.
void write_obj_curves(std::ostream& out, const std::vector<NamedCurve>& curves);

}  // namespace ripstop
