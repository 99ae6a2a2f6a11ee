#pragma once

#include <vector>

#include "ripstop/model/plan/cut_plan.h"

namespace ripstop {

/// The mark of a finding: the vertex nearest to the finding's place.
struct FindingMark {
    int vertex = 0;
    std::size_t finding = 0;  ///< index in `Verdict::findings`
};

/// At most one mark per vertex: that of the first finding there. Findings without a place have none.
std::vector<FindingMark> finding_marks(const FlatTile& tile);

/// The ends of a proposed seam on the cloth [m]: the points of the flat outline nearest to its ends in space. Empty
/// without a proposal. Requires flat positions.
std::vector<Vec2> proposed_ends(const FlatTile& tile);

}  // namespace ripstop
