#pragma once

#include <vector>

#include "ripstop/model/piece/pattern_piece.h"
#include "ripstop/model/plan/cut_plan.h"

namespace ripstop {

/// A piece's sew line, before notches and writing are added.
struct PieceOutline {
    Points2 sew_line;              ///< closed, counter-clockwise, the first point not repeated (#P x 2)
    std::vector<PieceEdge> edges;  ///< with their allowances; together they cover the sew line, in order
    std::vector<int> edge_of;      ///< for each boundary edge of the tile: index in `edges`
};

/// The outlines of all pieces, in the order of the tiles. A tile without flat positions has an empty one; a
/// flattening that is turned over has a sew line without edges.
///
/// An edge extends from one corner of the tile to the next, or to where the seam type or the allowance changes or
/// a seam ends in a free edge. Its points are boundary vertices with exact ends; vertices that it can do without
/// at `chord_error` [m] are dropped (`simplified`). Its length is that of all its vertices. Mates are in the order
/// of the edge. O(#seams + #boundary log #boundary).
std::vector<PieceOutline> make_outlines(const CutPlan& plan, double chord_error);

}  // namespace ripstop
