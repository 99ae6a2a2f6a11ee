#pragma once

#include <string>
#include <vector>

#include "ripstop/model/project/project.h"
#include "ripstop/model/tile/envelope.h"

namespace ripstop {

/// Gives each seam its type and each chain the finish of what of it is in no seam, by the project's `seams`: a rule
/// that names its tiles in full goes first, among the others the later before the earlier; where none fits,
/// `flat-felled` and `hem` as the project's `seam_types` have them.
///
/// An edge runs along the warp where it goes farther that way than across: the sum of its squared components over the
/// seam, against the warp of both tiles. O(#seams x #rules).
void give_seam_types(Envelope& envelope, const Project& project);

/// A sentence for each name, rule and material of the project that fits nothing in the envelope, in the project's
/// order: most likely misspelt. `envelope` must be whole.
std::vector<std::string> unused_entries(const Project& project, const Envelope& envelope);

}  // namespace ripstop
