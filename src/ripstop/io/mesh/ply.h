#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "ripstop/model/tile/cad_model.h"

namespace ripstop {

/// The surfaces of a Stanford PLY: ascii, binary little and big endian; what has no meaning here is skipped by its
/// declared size.
///
/// Vertices. `x y z` of the element `vertex`, in any type; `u v`, `s t` or `texture_u texture_v` are the flat position
/// (`drawn`). Nothing is welded, vertices without a face are dropped.
///
/// Faces. `vertex_indices` or `vertex_index` of the element `face`, counted from 0, polygons fanned (`fan_corner`); and
/// of the element `tristrips`, where -1 ends a strip and triangles with a vertex twice, which join strips, are left
/// out.
///
/// Surfaces. The faces with one number under the first of `tile`, `tile_id`, `label`, `group`, `object` that `face` has
/// are a surface: NAME where a line of the header says `comment tile NUMBER NAME`, else `STEM_NUMBER`, in the order of
/// their first faces; numbers with one name are one surface. Without such a property each connected part is one:
/// `STEM`, or `STEM_01`, ….
///
/// Warp. `warp_x warp_y warp_z` or `grain_x grain_y grain_z` of the faces, on all of a surface or none (0 0 0). Unit:
/// `comment unit mm`.
///
/// Throws InputError `NAME:LINE: …`, or `NAME: byte N: …` in the body of a binary file, for a header or body that does
/// not hold together, coordinates that are not finite and below 1e12, and faces as `make_surfaces`. Linear in time and
/// memory, whatever the header's counts.
CadModel read_ply(std::istream& in, const std::string& name);

/// Binary, little endian, in double precision: surfaces in metres, which it says, as numbers `tile` from 1 with their
/// names in comments; `u v` where all have drawn positions, the warp where one has it. Reading gives equal meshes where
/// every vertex is used and names differ.
void write_ply(std::ostream& out, const std::vector<NamedMesh>& meshes);

}  // namespace ripstop
