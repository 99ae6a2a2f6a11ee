#pragma once

#include <string>
#include <vector>

#include "ripstop/model/piece/piece_change.h"

namespace ripstop {

/// The changes between two revisions, for a terminal: one line per piece, then one for each seam type, edge, drawn
/// line and field that changed. `No piece changed.` if there are none.
std::string revision_text(const std::vector<PieceChange>& changes, const std::vector<SeamTypeChange>& seam_types = {});

/// The same as JSON: docs/diff.schema.json.
std::string revision_json(const std::vector<PieceChange>& changes, const std::vector<SeamTypeChange>& seam_types,
                          const std::string& before, const std::string& after);

}  // namespace ripstop
