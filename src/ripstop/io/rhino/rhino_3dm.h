#pragma once

#include <iosfwd>
#include <string>

#include "ripstop/model/tile/cad_model.h"

namespace ripstop {

/// Reads a Rhino model (`.3dm`, Rhino 2 to 8): meshes become surfaces, curves become polylines; layers and the
/// unit are read too.
///
/// Hidden objects, objects on a hidden layer or a layout, and objects that cannot be a tile (points, texts,
/// dimensions, lights, …) are left out with a remark. Breps, surfaces, extrusions, SubDs, point clouds and blocks
/// without a definition are listed in `unread` by name; so is a whole file of Rhino 1.
///
/// Blocks are resolved recursively. An instance that mirrors also reverses the corners of its triangles, so the
/// outside of a mirrored gore stays outside. For names see `rhino_surface_names`, for attributes
/// `rhino_attributes`, for vertices and triangles `read_rhino_mesh`. Texture coordinates do not become drawn
/// positions.
///
/// Throws InputError `NAME: byte N: …` if the file is cut short or damaged. Throws InputError with the object's
/// name for a mesh with an index without a vertex, and for a block that contains itself. Linear in the file's size
/// except for blocks, which may produce at most a million plus 200 times the file's bytes of vertices, triangles
/// and characters.
CadModel read_rhino_3dm(std::istream& in, const std::string& name);

}  // namespace ripstop
