#pragma once

#include <string>
#include <vector>

#include "ripstop/model/piece/piece_change.h"

namespace ripstop {

/// What changed between two revisions, for a terminal: a line a piece, then a line for each seam type, edge, drawn line
/// and field that changed. `No piece changed.` where none did.
std::string revision_text(const std::vector<PieceChange>& changes, const std::vector<SeamTypeChange>& seam_types = {});

/// docs/diff.schema.json.
std::string revision_json(const std::vector<PieceChange>& changes, const std::vector<SeamTypeChange>& seam_types,
                          const std::string& before, const std::string& after);

}  // namespace ripstop
