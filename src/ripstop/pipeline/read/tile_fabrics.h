#pragma once

#include <string>
#include <vector>

#include "ripstop/model/project/project.h"
#include "ripstop/model/tile/envelope.h"

namespace ripstop {

/// The fabric of a project's envelope: `named`, where not empty, else the project's, else isotropic. A file that the
/// project names is looked for beside it first. Throws InputError (`fabric_named`).
Fabric envelope_fabric(const std::string& named, const std::optional<Project>& project);

/// Gives each tile the fabric that is said of it: by the project's entry for it, else by its attribute `fabric`, else
/// by what the project's `materials` say of its attribute `material`. A `fabric` that stands in `materials` is what
/// they say of it. A tile of which nothing is said, or that would be of `standard`, keeps none of its own.
///
/// Returns a sentence for each fabric that a file names and nobody knows: its tiles are of the standard. Throws
/// InputError for one that the project names.
std::vector<std::string> give_fabrics(Envelope& envelope, const std::optional<Project>& project,
                                      const Fabric& standard);

}  // namespace ripstop
