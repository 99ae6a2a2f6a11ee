#pragma once

#include <iosfwd>
#include <string>

#include "ripstop/model/tile/cad_model.h"

namespace ripstop {

/// What a Rhino model (`.3dm`, Rhino 2 to 8) holds: its meshes as surfaces, its curves as polylines, its layers and its
/// unit.
///
/// Left out, with a remark: what is hidden, on a hidden layer or on a layout, and what can be no tile (points, texts,
/// dimensions, lights, …). Breps, surfaces, extrusions, SubDs, point clouds and blocks that lead nowhere are `unread`,
/// each by its name; so is the whole of a file of Rhino 1.
///
/// Blocks are followed to what they are made of, through blocks in blocks. An instance that mirrors turns the corners
/// of its triangles round, so that the outside of a mirrored gore is its outside. Names: `rhino_surface_names`;
/// attributes: `rhino_attributes`; vertices and triangles: `read_rhino_mesh`. Texture coordinates are no drawn
/// positions.
///
/// Throws InputError `NAME: byte N: …` where the file is cut short or damaged, and naming the object for a mesh with
/// faces at vertices that are not there, and for blocks in circles. Linear in the file's size but for blocks, which may
/// make at most a million and 200 times the file's bytes of vertices, triangles and characters.
CadModel read_rhino_3dm(std::istream& in, const std::string& name);

}  // namespace ripstop
