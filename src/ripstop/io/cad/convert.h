#pragma once

#include <filesystem>
#include <optional>
#include <span>

#include "ripstop/base/progress.h"
#include "ripstop/base/text/units.h"
#include "ripstop/io/cad/converted.h"

namespace ripstop {

/// A polyline in a curve that turns by t between its vertices is short by t²/24 of its length: this turn [rad] keeps
/// lengths within 0.01 %, a tenth of what seams are held to.
inline constexpr double turn_of_accuracy = 0.04898979485566356;

/// How the surfaces of a CAD become meshes and tiles. Where neither `chord_error` nor `edge_length` is given, edges
/// turn by `turn_of_accuracy` at most and a tile is about twelve edges across.
struct MeshingOptions {
    std::optional<double> chord_error = {};  ///< how far a surface may lie off its triangles [m], instead of the turn
    std::optional<double> edge_length = {};  ///< how long edges are at most [m]
    double sewing_tolerance = 0.5 * millimetre;  ///< faces are sewn where their edges lie within it [m]
    std::optional<double> metres_per_unit = {};  ///< of the file, whatever it says
    TilesAs tiles = TilesAs::faces;
    double timeout = 1800;              ///< [s]
    std::filesystem::path mesher = {};  ///< the `ripstop-cad` to run; empty: beside this program, else installed
    Progress progress = {};             ///< told the share of faces that are meshed, and `face 12 of 160`
};

/// Throws InputError for lengths that are not positive.
void require_sound(const MeshingOptions& options);

/// The file formats that hold exact surfaces.
struct CadFormat {
    const char* extension;  ///< with its dot, in lower case
    const char* description;
};
std::span<const CadFormat> cad_formats();

/// The surfaces of a STEP, IGES or BREP file, in the file's own numbers, by the program `ripstop-cad` in a process of
/// its own. Throws InputError in one sentence where it is absent, refuses the file, crashes, does not end in time, or
/// answers with something else.
CadModel convert_cad(const std::filesystem::path& file, const MeshingOptions& options);

/// Everything in a Rhino file of any version that openNURBS gives surfaces of, in the file's own numbers: by Node.js
/// with rhino3dm, and `ripstop-cad` for what are NURBS. Without `ripstop-cad` surfaces are as Rhino had meshed them,
/// and those it had not are named as left out. Every object is there in the file's order, without faces where none
/// could be made. Throws InputError as above.
ConvertedModel convert_rhino(const std::filesystem::path& file, const MeshingOptions& options);

}  // namespace ripstop
