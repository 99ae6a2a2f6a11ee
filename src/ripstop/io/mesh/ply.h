#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "ripstop/model/tile/cad_model.h"

namespace ripstop {

/// Reads the surfaces of a Stanford PLY file: ascii, or binary in either byte order. Skips unknown elements and
/// properties by their declared sizes.
///
/// Vertices. `x y z` of the element `vertex`, in any type. `u v`, `s t` or `texture_u texture_v` is the flat
/// position (`drawn`). Nothing is welded; vertices without a face are dropped.
///
/// Faces. `vertex_indices` or `vertex_index` of the element `face`, counted from 0; polygons are fanned
/// (`fan_corner`). Also the element `tristrips`, in which -1 ends a strip. Triangles with a repeated vertex, which
/// join strips, are left out.
///
/// Surfaces. The first property of `face` among `tile`, `tile_id`, `label`, `group` and `object` numbers the
/// surfaces. A surface is called NAME if a header line says `comment tile NUMBER NAME`, else `STEM_NUMBER`.
/// Surfaces are ordered by their first faces; numbers with the same name form one surface. Without such a property
/// each connected part is a surface: `STEM`, or `STEM_01`, ….
///
/// Warp. `warp_x warp_y warp_z` or `grain_x grain_y grain_z` of the faces, for all faces of a surface or for none
/// (0 0 0). Unit: `comment unit mm`.
///
/// Throws InputError `NAME:LINE: …`, or `NAME: byte N: …` in a binary body, for a malformed header or body, for a
/// coordinate that is not finite or not below 1e12, and for faces as `make_surfaces` does. Linear in the file's
/// size in time and memory, whatever the header's counts say.
CadModel read_ply(std::istream& in, const std::string& name);

/// Writes a binary little-endian PLY in double precision, in metres, which its header states. Surfaces are
/// numbered `tile` from 1 and named in comments. `u v` is written if all surfaces have drawn positions, the warp
/// if any has one. Reading returns equal meshes if every vertex is used and all names differ.
void write_ply(std::ostream& out, const std::vector<NamedMesh>& meshes);

}  // namespace ripstop
