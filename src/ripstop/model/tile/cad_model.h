#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ripstop/base/text/units.h"
#include "ripstop/mesh/triangle_mesh.h"

namespace ripstop {

/// Metadata that a file gives for an object: `layer` (whole path, `a::b`), `group`, `material`, and the designer's
/// own entries (Rhino's attribute user text), by key.
using Attributes = std::map<std::string, std::string>;

/// A named surface as read or generated, before it is checked and becomes a tile.
struct NamedMesh {
    std::string name;
    TriangleMesh mesh;
    std::optional<Points2> drawn =
        {};             ///< #V x 2: flat positions from the file's texture coordinates, if each vertex has exactly one
    Points3 warp = {};  ///< #F x 3: the warp of each triangle, any non-zero length; empty: not given
    Attributes attributes = {};
    std::string fault = {};  ///< why the file gives no complete surface here, with the place; empty if it does
};

/// A curve of a file as a polyline; a closed one repeats its first point.
struct NamedCurve {
    std::string name;
    Points3 points;  ///< at least 2 x 3
    Attributes attributes = {};
};

/// An object of a file that is neither surface nor curve, with the reason.
struct UnreadObject {
    std::string name;
    std::string type;    ///< type name in the program that wrote it: `Brep`, `SubD`, `Point`, …
    std::string reason;  ///< a sentence for the designer, with a remedy
    Attributes attributes = {};
};

/// The content of a CAD or mesh file. Coordinates are the file's own numbers until `in_metres`.
struct CadModel {
    std::vector<NamedMesh> surfaces;
    std::vector<NamedCurve> curves = {};
    std::vector<UnreadObject> unread = {};
    std::optional<LengthUnit> unit = {};    ///< if the file states one
    std::vector<std::string> layers = {};   ///< whole paths, in the file's order, if the format has layers
    std::vector<std::string> remarks = {};  ///< interpretations that differ from the file, one sentence each
    double rounding = 0;  ///< rounding of coordinates stored in single precision; 0: exact [file's unit]
};

/// The rounding of numbers up to `largest` in single precision: half a unit in the last place.
double single_rounding(double largest);

/// Converts the model to metres: multiplies all coordinates, drawn positions and the rounding by `metres_per_unit`.
CadModel in_metres(CadModel model, double metres_per_unit);

}  // namespace ripstop
