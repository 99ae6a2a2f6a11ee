#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ripstop/assembly/faults/judge_unit.h"
#include "ripstop/base/text/units.h"
#include "ripstop/io/cad/convert.h"
#include "ripstop/model/plan/envelope_check.h"
#include "ripstop/model/project/project.h"
#include "ripstop/model/tile/cad_model.h"
#include "ripstop/model/tile/envelope.h"
#include "ripstop/pipeline/remesh/remesh_envelope.h"

namespace ripstop {

/// Options of `read_envelope`.
struct ReadOptions {
    std::optional<LengthUnit> unit = {};   ///< unit of the file's numbers; default: the file's own, else metres
    std::vector<std::string> only = {};    ///< globs of the tile names to keep; empty: all
    std::vector<std::string> layers = {};  ///< globs of the layers to read; empty: all
    double grain_turn = 0;                 ///< if no warp is given: rotates the longest axis [rad]
    std::optional<Project> project = {};
    double seam_tolerance = 0.5 * millimetre;  ///< largest gap between edges that are sewn together [m]
    Fabric fabric = {};                        ///< of the envelope; tiles with this fabric store none of their own
    MeshingOptions meshing = {};               ///< for CAD surfaces; unit and sewing tolerance come from above
    bool fair_seams = false;                   ///< `read_input` replaces zigzag edges by fair curves (`fair_seams`)
    RemeshOptions remesh = {};                 ///< for `read_input`, with this seam tolerance; off by default
    bool size_is_meant = false;                ///< the unit is certain
    /// Called as soon as the unit is in doubt, before the work that depends on the size.
    std::function<void(const UnitDoubt&)> doubts = {};
};

/// An envelope with the meshes of the file.
struct AsDrawn {
    Envelope envelope;
    std::vector<std::string> remarks;  ///< remarks of the input without those on remeshing
};

/// An envelope with the information from its file.
struct EnvelopeInput {
    Envelope envelope;
    std::optional<AsDrawn> drawn = {};      ///< before remeshing; empty if no tile was remeshed
    UnitRead unit;                          ///< unit of the file's numbers
    bool unit_assumed = false;              ///< the unit was neither given nor stated in the file
    std::vector<std::string> remarks = {};  ///< one sentence for each thing left out or read differently
    std::vector<std::string> unused = {};   ///< one sentence for each entry of the project that matches nothing
    std::optional<UnitDoubt> doubt = {};    ///< doubt about the unit, from the surfaces of the file
    std::vector<EnvelopeIssue> issues =
        {};              ///< faults of the file: `no_tile` for a surface that cannot be a tile and is left out,
                         ///< `precision` if rounding exceeds the seam tolerance
    Flight flight = {};  ///< the project's flight conditions, in the envelope's coordinates
};

/// Reads a file (`read_model`), makes a tile of every surface and finds the seams between the kept tiles
/// (`find_seams`).
///
/// Surfaces get the names of the project (`name_tiles`) before anything else refers to names. Each tile gets its fabric
/// (`give_fabrics`) and each seam its type (`give_seam_types`). Entries of the project that match nothing are reported,
/// unless only some tiles are read.
///
/// The warp of a tile comes from, in this order: the project; a line on the tile, on a layer named GRAIN or WARP or in
/// one of the project's `grain_layers`; the file, per triangle or as the surface's attribute `warp` (x, y, z); the
/// longest axis. Objects without a surface become remarks. Finally, zigzag edges are made fair on request
/// (`fair_seams`), and tiles are remeshed as `remesh` says (`remesh_envelope`); `make_envelope` does neither.
///
/// Meshes are mended (`mend_surfaces`). A model far from the origin, and the project's points with it, gets a nearer
/// origin (`far_origin`). Both are reported as remarks. A surface that still is no tile becomes an issue and is left
/// out.
///
/// Throws InputError for a file that cannot be read, for a file without any tile (one sentence for each surface), and
/// for a glob in `only` or `layers` that matches nothing.
EnvelopeInput read_input(const std::filesystem::path& file, const ReadOptions& options);

/// The last step of `read_input`, for an envelope from another source: makes zigzag edges fair, remeshes tiles as the
/// options say, and keeps the drawn meshes. Remarks report what was done.
void remesh_input(EnvelopeInput& input, const ReadOptions& options);

/// The envelope alone; throws for a surface that cannot be a tile.
Envelope read_envelope(const std::filesystem::path& file, const ReadOptions& options);

/// The same from surfaces in memory, in metres, unchanged.
Envelope make_envelope(std::vector<NamedMesh> surfaces, const ReadOptions& options);

}  // namespace ripstop
