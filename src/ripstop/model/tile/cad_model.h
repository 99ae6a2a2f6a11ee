#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ripstop/base/text/units.h"
#include "ripstop/mesh/triangle_mesh.h"

namespace ripstop {

/// What a file says of an object in its own words: `layer` (whole path, `a::b`), `group`, `material`, and whatever the
/// designer wrote beside it (Rhino's attribute user text), by key.
using Attributes = std::map<std::string, std::string>;

/// A named surface before it is known to be a tile: what a file or a generator gives.
struct NamedMesh {
    std::string name;
    TriangleMesh mesh;
    std::optional<Points2> drawn =
        {};             ///< #V x 2: flat positions from the file's texture coordinates, if each vertex has one
    Points3 warp = {};  ///< #F x 3: the warp of each triangle, any length but zero; empty: not given
    Attributes attributes = {};
    std::string fault = {};  ///< why the file gives no whole surface here, with the place; empty: it does
};

/// A curve of a file as a polyline; a closed one ends where it starts.
struct NamedCurve {
    std::string name;
    Points3 points;  ///< at least 2 x 3
    Attributes attributes = {};
};

/// An object of a file that gives neither surface nor curve, and why.
struct UnreadObject {
    std::string name;
    std::string type;    ///< in the words of the program that wrote it: `Brep`, `SubD`, `Point`, …
    std::string reason;  ///< a sentence for the designer, with what to do
    Attributes attributes = {};
};

/// What a file of a CAD or a mesh holds. Coordinates are the file's own numbers until `in_metres`.
struct CadModel {
    std::vector<NamedMesh> surfaces;
    std::vector<NamedCurve> curves = {};
    std::vector<UnreadObject> unread = {};
    std::optional<LengthUnit> unit = {};    ///< where the file says one
    std::vector<std::string> layers = {};   ///< whole paths, in the file's order, where the format has layers
    std::vector<std::string> remarks = {};  ///< what was taken otherwise than it stands, one sentence each
    double rounding = 0;  ///< of coordinates for being stored in single precision; 0: they are exact [file's unit]
};

/// By how much numbers up to `largest` are rounded in single precision: half a unit in the last place.
double single_rounding(double largest);

/// The model in metres: every coordinate, drawn positions too, and the rounding, times the metres in one unit of the
/// file.
CadModel in_metres(CadModel model, double metres_per_unit);

}  // namespace ripstop
