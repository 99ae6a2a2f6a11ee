#pragma once

#include <filesystem>
#include <optional>
#include <span>

#include "ripstop/base/progress.h"
#include "ripstop/base/text/units.h"
#include "ripstop/io/cad/converted.h"

namespace ripstop {

/// The largest turn of an edge between two vertices [rad]. A polyline whose curve turns by t between vertices is
/// shorter than the curve by t²/24 of its length. This turn keeps lengths within 0.01 %, a tenth of the tolerance
/// on seams.
inline constexpr double turn_of_accuracy = 0.04898979485566356;

/// How CAD surfaces become meshes and tiles. If neither `chord_error` nor `edge_length` is set, edges turn by at
/// most `turn_of_accuracy` and a tile is about twelve edges across.
struct MeshingOptions {
    std::optional<double> chord_error = {};      ///< largest distance of a surface from its triangles [m];
                                                 ///< replaces the turn
    std::optional<double> edge_length = {};      ///< longest edge [m]
    double sewing_tolerance = 0.5 * millimetre;  ///< faces are sewn if their edges lie within this distance [m]
    std::optional<double> metres_per_unit = {};  ///< overrides the unit that the file states
    TilesAs tiles = TilesAs::faces;
    double timeout = 1800;              ///< limit on the run time [s]
    std::filesystem::path mesher = {};  ///< the `ripstop-cad` to run; empty: the one in `programs`
    /// The `bin` folder of an installed Ripstop, in which its converters are; empty: the folder of the running
    /// program.
    std::filesystem::path programs = {};
    Progress progress = {};  ///< receives the share of faces that are meshed, and `face 12 of 160`
};

/// Throws InputError if a length is not positive.
void require_sound(const MeshingOptions& options);

/// File formats with exact surfaces.
struct CadFormat {
    const char* extension;  ///< in lower case, with its dot
    const char* description;
};
std::span<const CadFormat> cad_formats();

/// Reads the surfaces of a STEP, IGES or BREP file, in the file's own unit, by running `ripstop-cad` in its own
/// process. Throws InputError with one sentence if that program is missing, refuses the file, crashes, times out
/// or writes something else than a model.
CadModel convert_cad(const std::filesystem::path& file, const MeshingOptions& options);

/// Reads every object of a Rhino file, of any version, that openNURBS can turn into surfaces, in the file's own
/// unit. Runs Node.js with rhino3dm, and `ripstop-cad` for NURBS surfaces. Without `ripstop-cad`, surfaces come as
/// the meshes that Rhino stored, and surfaces without a stored mesh are listed as left out. The result has every
/// object in the file's order; one that could not be meshed has no faces. Throws InputError as `convert_cad` does.
ConvertedModel convert_rhino(const std::filesystem::path& file, const MeshingOptions& options);

}  // namespace ripstop
