#pragma once

#include <vector>

#include "ripstop/model/plan/cut_plan.h"

namespace ripstop {

/// Where something is wrong with a tile: the vertex nearest to the place that a finding names.
struct FindingMark {
    int vertex = 0;
    std::size_t finding = 0;  ///< in `Verdict::findings`
};

/// One a vertex: of several findings the first. Findings that name no place have none.
std::vector<FindingMark> finding_marks(const FlatTile& tile);

/// The ends of a proposed seam on the cloth [m]: the places of the flat outline that lie nearest to them in space. None
/// where nothing is proposed. Requires flat positions.
std::vector<Vec2> proposed_ends(const FlatTile& tile);

}  // namespace ripstop
