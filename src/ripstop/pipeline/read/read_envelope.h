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

/// How `read_envelope` understands a file.
struct ReadOptions {
    std::optional<LengthUnit> unit = {};   ///< of the file's numbers, whatever the file says; else its own, else metres
    std::vector<std::string> only = {};    ///< globs of tile names to keep; all where empty
    std::vector<std::string> layers = {};  ///< globs of the layers whose objects are read; all where empty
    double grain_turn = 0;                 ///< where no warp is given: the longest axis turned by this [rad]
    std::optional<Project> project = {};
    double seam_tolerance = 0.5 * millimetre;  ///< edges to be sewn together lie within this [m]
    Fabric fabric = {};                        ///< of the envelope: tiles of it have none of their own
    MeshingOptions meshing = {};  ///< of a CAD's surfaces; its unit and sewing tolerance are the ones above
    bool fair_seams = false;      ///< by `read_input`: edges that zigzag are cut along fair curves (`fair_seams`)
    RemeshOptions remesh = {};    ///< by `read_input`, at this seam tolerance; never unless asked for
    bool size_is_meant = false;   ///< the unit is not to be doubted
    /// Is told at once where the unit is in doubt, before the work that the size costs.
    std::function<void(const UnitDoubt&)> doubts = {};
};

/// An envelope with the meshes of its file.
struct AsDrawn {
    Envelope envelope;
    std::vector<std::string> remarks;  ///< those of the input without what is said of remeshing
};

/// An envelope with what its file said of it.
struct EnvelopeInput {
    Envelope envelope;
    std::optional<AsDrawn> drawn = {};      ///< before tiles were remeshed; nothing where none was
    UnitRead unit;                          ///< of the file's numbers
    bool unit_assumed = false;              ///< neither given nor said by the file
    std::vector<std::string> remarks = {};  ///< what was left out or taken otherwise than it stands, one sentence each
    std::vector<std::string> unused = {};   ///< entries of the project that fit nothing, a sentence each
    std::optional<UnitDoubt> doubt = {};    ///< of the unit, from the surfaces as they are in the file
    std::vector<EnvelopeIssue> issues =
        {};              ///< what is wrong with the file: `no_tile` for a surface that is none and is
                         ///< left out, `precision` where rounding is more than the seam tolerance
    Flight flight = {};  ///< the project's, in the envelope's coordinates
};

/// Reads a file (`read_model`), makes every surface in it a tile and finds the seams between those kept (`find_seams`).
///
/// Surfaces are called what the project calls them (`name_tiles`) before anything else looks at names; each tile gets
/// its fabric (`give_fabrics`), each seam its type (`give_seam_types`). The project's entries that fit nothing are
/// named, unless only some tiles are read.
///
/// The warp of a tile is, in this order: the project's; the line that lies on the tile, on a layer called GRAIN or WARP
/// or on one of the project's `grain_layers`; the file's own for the surface, in its triangles or as the attribute
/// `warp` (x, y, z); the longest axis. Objects that give no surface become remarks. Last, edges that zigzag are made
/// fair where that is asked for (`fair_seams`), and tiles are remeshed where `remesh` says so (`remesh_envelope`);
/// `make_envelope` never does.
///
/// Meshes are mended (`mend_surfaces`); what lies far from the origin is counted from nearer by (`far_origin`), points
/// of the project too. Both are remarks. A surface that is no tile even so is an issue, and the others are read without
/// it.
///
/// Throws InputError for a file that cannot be read or holds no surface that is a tile: a sentence for each that is
/// none; and for a glob in `only` or `layers` that fits nothing.
EnvelopeInput read_input(const std::filesystem::path& file, const ReadOptions& options);

/// The last step of `read_input`, for an envelope that comes from elsewhere: makes zigzag edges fair and remeshes tiles as
/// the options say, and keeps the drawn meshes. Remarks say what was done.
void remesh_input(EnvelopeInput& input, const ReadOptions& options);

/// The envelope alone; surfaces that are no tiles are refused.
Envelope read_envelope(const std::filesystem::path& file, const ReadOptions& options);

/// The same from surfaces at hand, in metres, as they are.
Envelope make_envelope(std::vector<NamedMesh> surfaces, const ReadOptions& options);

}  // namespace ripstop
