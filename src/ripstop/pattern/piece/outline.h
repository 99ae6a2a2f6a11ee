#pragma once

#include <vector>

#include "ripstop/model/piece/pattern_piece.h"
#include "ripstop/model/plan/cut_plan.h"

namespace ripstop {

/// A piece's sew line, before anything is put on it.
struct PieceOutline {
    Points2 sew_line;              ///< closed, counter-clockwise, the first point not repeated (#P x 2)
    std::vector<PieceEdge> edges;  ///< with their allowances; they cover the sew line once, in its order
    std::vector<int> edge_of;      ///< of each boundary edge of the tile: in `edges`
};

/// The outlines of all pieces, in the order of the tiles; a tile without flat positions has an empty one, a
/// flattening that is turned over a sew line without edges.
///
/// An edge goes from one corner of the tile to the next, or to where the seam type or the allowance changes or a seam
/// ends in a free edge; its points are boundary vertices, ends exact, with those left out that it does without at
/// `chord_error` [m] (`simplified`). Its length is that of all its vertices. Mates stand in the order of the edge.
/// O(#seams + #boundary log #boundary).
std::vector<PieceOutline> make_outlines(const CutPlan& plan, double chord_error);

}  // namespace ripstop
