#pragma once

#include <iosfwd>
#include <set>
#include <string>
#include <vector>

#include "ripstop/model/tile/cad_model.h"

namespace ripstop {

/// A meshed face of a CAD object. Faces that are sewn together have bitwise equal vertices along their common
/// edge.
struct ConvertedFace {
    std::string name = {};  ///< empty: none
    TriangleMesh mesh;
    double area = 0;         ///< of the exact surface [unit²]; 0: unknown
    double chord_error = 0;  ///< largest distance of the surface from its triangles [unit]
    Attributes attributes = {};
};

/// A CAD object and its meshed faces.
struct ConvertedObject {
    std::string name = {};  ///< empty: none
    std::string type;       ///< `Solid`, `Shell`, `Brep`, …
    Attributes attributes = {};
    std::vector<ConvertedFace> faces = {};
};

/// The contents of a CAD file after meshing, in the file's own unit.
struct ConvertedModel {
    std::vector<ConvertedObject> objects;
    std::vector<NamedCurve> curves = {};
    std::vector<UnreadObject> unread = {};
    std::optional<LengthUnit> unit = {};  ///< empty if the file states none
    std::vector<std::string> layers = {};
    std::vector<std::string> remarks = {};
};

/// Writes one line of JSON (objects, their faces with the counts `vertices` and `triangles`, all texts, curves
/// with their `points`), then for each face its coordinates (#V x 3 little-endian doubles) and corners (#F x 3
/// little-endian 32-bit integers, from 0). Reading returns the same bits and skips unknown JSON keys.
void write_converted(std::ostream& out, const ConvertedModel& model);

/// Reads what `write_converted` wrote. Throws InputError `NAME: …` for any other text, for a count that does not
/// match the number of bytes, for a coordinate that is not finite or not below 1e12, and for a corner that is not
/// a vertex. Memory is bounded by the size of the stream.
ConvertedModel read_converted(std::istream& in, const std::string& name);

/// Which CAD shape becomes a tile: each face, or each object.
enum class TilesAs { faces, objects };

/// The surfaces of a converted model: one for each face, or one for each object, with its faces welded where
/// vertices coincide.
///
/// An object takes its own name; else the last part of its layer's path, if it is alone on that layer; else
/// STEM_01, STEM_02, … A face of an object with several faces is called OBJECT/FACE, or OBJECT_01, … if the face
/// has no name. A name that is used twice or is among `taken` gets `_2`, `_3`, …
///
/// Attributes of a face override those of its object. A face whose mesh misses its exact area by more than 1 %
/// gives a remark.
CadModel as_surfaces(ConvertedModel model, TilesAs tiles, const std::string& stem, std::set<std::string> taken = {});

}  // namespace ripstop
