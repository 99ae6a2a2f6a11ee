#pragma once

#include <array>
#include <string>
#include <vector>

#include "ripstop/model/plan/accuracy.h"
#include "ripstop/model/plan/verdict.h"

namespace ripstop {

/// The result for a hypothetical tile: half of a tile, or two in one.
struct Trial {
    int triangles = 0;
    Accuracy accuracy;
    Verdict verdict;
};

/// A proposed seam through a tile that cannot be manufactured. It was tested by flattening both halves; nothing is
/// cut.
struct SplitProposal {
    std::string direction;        ///< `along the warp` or `across the warp`
    std::vector<Vec3> line;       ///< polyline on the surface from edge to edge, straight on the cloth [m]
    std::array<Trial, 2> halves;  ///< left and right of the line, as seen along it from outside
    int tried = 0;                ///< number of lines tested
    int findings_before = 0;      ///< number of findings on the whole tile
};

/// Two neighbouring tiles that could be merged within tolerance.
struct MergeProposal {
    int tile_a = 0, tile_b = 0;  ///< indices in `CutPlan::tiles`
    int seam = 0;                ///< index in `CutPlan::seams` of the seam that would be removed
    Trial merged;
};

}  // namespace ripstop
