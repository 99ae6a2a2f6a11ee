#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ripstop/base/units.h"
#include "ripstop/io/project_json.h"
#include "ripstop/model/envelope.h"

namespace ripstop {

struct ReadOptions {
    double metres_per_unit = 1;          ///< of the file
    std::vector<std::string> only = {};  ///< globs of tile names to keep; all where empty
    double grain_turn = 0;               ///< where no warp is given: the longest axis turned by this [rad]
    std::optional<Project> project = {};
    double seam_tolerance = 0.5 * millimetre;  ///< edges to be sewn together lie within this [m]
};

/// Reads a mesh file, makes every surface in it a tile and finds the seams between those kept (`find_seams`). Throws InputError for a file that cannot be read, and for
/// surfaces that are no tiles: one sentence each, all of them at once; and for a glob in `only` that fits no surface.
Envelope read_envelope(const std::filesystem::path& file, const ReadOptions& options);

/// The same from surfaces at hand.
Envelope make_envelope(std::vector<NamedMesh> surfaces, const ReadOptions& options);

}  // namespace ripstop
