#pragma once

#include <string>
#include <vector>

#include "ripstop/model/project/project.h"
#include "ripstop/model/tile/envelope.h"

namespace ripstop {

/// Gives each seam its type, and each chain the finish of its unsewn part, by the project's `seams`. Rules that name
/// their tiles in full take precedence; among the others, later rules do. Without a matching rule, the types are
/// `flat-felled` and `hem` as defined in the project's `seam_types`.
///
/// An edge runs along the warp if its component along the warp exceeds that across: the squared components are summed
/// over the seam, relative to the warp of both tiles. O(#seams x #rules).
void give_seam_types(Envelope& envelope, const Project& project);

/// One sentence for each name, rule and material of the project that matches nothing in the envelope, in the project's
/// order: probably a misspelling. `envelope` must be complete.
std::vector<std::string> unused_entries(const Project& project, const Envelope& envelope);

}  // namespace ripstop
