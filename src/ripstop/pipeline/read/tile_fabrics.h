#pragma once

#include <string>
#include <vector>

#include "ripstop/model/project/project.h"
#include "ripstop/model/tile/envelope.h"

namespace ripstop {

/// The fabric of a project's envelope: `named` unless empty, else the project's, else isotropic. A file named in the
/// project is searched for next to the project first. Throws InputError (`fabric_named`).
Fabric envelope_fabric(const std::string& named, const std::optional<Project>& project);

/// Gives each tile its fabric, from the first of: the project's entry for the tile; its attribute `fabric`; the
/// project's `materials` for its attribute `material`. A `fabric` that is listed in `materials` is replaced by its
/// entry there. A tile without any of these, or with the fabric `standard`, stores no fabric of its own.
///
/// Returns one sentence for each unknown fabric named in a file: its tiles use the standard fabric. Throws InputError
/// for an unknown one named in the project.
std::vector<std::string> give_fabrics(Envelope& envelope, const std::optional<Project>& project,
                                      const Fabric& standard);

}  // namespace ripstop
