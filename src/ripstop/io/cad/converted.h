#pragma once

#include <iosfwd>
#include <set>
#include <string>
#include <vector>

#include "ripstop/model/tile/cad_model.h"

namespace ripstop {

/// A face of a CAD's object, meshed. Faces sewn together have the same vertices along their seam, to the last bit.
struct ConvertedFace {
    std::string name = {};  ///< empty: none
    TriangleMesh mesh;
    double area = 0;         ///< of the exact surface [unit²]; 0: not known
    double chord_error = 0;  ///< how far the surface lies off its triangles at most [unit]
    Attributes attributes = {};
};

/// An object of a CAD file with its faces, each meshed.
struct ConvertedObject {
    std::string name = {};  ///< empty: none
    std::string type;       ///< `Solid`, `Shell`, `Brep`, …
    Attributes attributes = {};
    std::vector<ConvertedFace> faces = {};
};

/// What a CAD file holds once its surfaces are meshed, in the file's own unit.
struct ConvertedModel {
    std::vector<ConvertedObject> objects;
    std::vector<NamedCurve> curves = {};
    std::vector<UnreadObject> unread = {};
    std::optional<LengthUnit> unit = {};  ///< where the file says one
    std::vector<std::string> layers = {};
    std::vector<std::string> remarks = {};
};

/// One line of JSON (objects, their faces with `vertices` and `triangles` as counts, all texts, curves with their
/// `points`), then face by face the coordinates (#V x 3, little-endian doubles) and the corners (#F x 3,
/// little-endian 32-bit integers, from 0). Exact: reading gives back the same bits. Keys of the JSON that are not
/// known are skipped.
void write_converted(std::ostream& out, const ConvertedModel& model);

/// Throws InputError `NAME: …` where the text is not that, a count does not fit the bytes there are, or a number is
/// no finite coordinate below 1e12 or no vertex. Memory is bounded by the stream's size.
ConvertedModel read_converted(std::istream& in, const std::string& name);

/// Which of a CAD's shapes becomes a tile.
enum class TilesAs { faces, objects };

/// The surfaces of a converted model: each face by itself, or the faces of an object welded where their vertices
/// coincide. An object is called by its name, else the last part of its layer where that holds one object alone, else
/// STEM_01, STEM_02, …; a face of several OBJECT/FACE, else OBJECT_01, …. What is still alike, or is among `taken`,
/// gets `_2`, `_3`, …. Attributes of the face go before those of its object. Faces whose mesh misses their exact area
/// by more than 1 % become remarks.
CadModel as_surfaces(ConvertedModel model, TilesAs tiles, const std::string& stem, std::set<std::string> taken = {});

}  // namespace ripstop
