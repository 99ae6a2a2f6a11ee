#pragma once

#include <array>
#include <string>
#include <vector>

#include "ripstop/model/plan/accuracy.h"
#include "ripstop/model/plan/verdict.h"

namespace ripstop {

/// What a tile that is not there would come to: a half of one, or two in one.
struct Trial {
    int triangles = 0;
    Accuracy accuracy;
    Verdict verdict;
};

/// A seam the designer may draw through a tile that cannot be made: tried by flattening the two halves, cut by nobody.
struct SplitProposal {
    std::string direction;        ///< `along the warp` or `across the warp`
    std::vector<Vec3> line;       ///< from edge to edge on the surface, straight on the cloth [m]
    std::array<Trial, 2> halves;  ///< left and right of the line, looking along it from outside
    int tried = 0;                ///< lines that were tried
    int findings_before = 0;      ///< of the whole tile
};

/// Two neighbours that could be one tile and stay within tolerance.
struct MergeProposal {
    int tile_a = 0, tile_b = 0;  ///< in `CutPlan::tiles`
    int seam = 0;                ///< in `CutPlan::seams`: the one that would go
    Trial merged;
};

}  // namespace ripstop
