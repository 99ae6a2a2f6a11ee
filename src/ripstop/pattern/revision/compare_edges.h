#pragma once

#include <vector>

#include "ripstop/model/piece/pattern_piece.h"
#include "ripstop/model/piece/piece_change.h"
#include "ripstop/pattern/revision/fit_outline.h"

namespace ripstop {

/// The edges of `a` that differ in `b`. Of all cyclic numberings, the one whose corners and middles are closest
/// after the motion pairs the edges. Returns none if the numbers of edges differ. Mates are compared by the names
/// of their pieces and the lengths sewn to them, not by seam ids. Lengths that differ by at most `tolerance` [m]
/// are equal. O(#edges²).
std::vector<EdgeChange> compare_edges(const PatternPiece& a, const PatternPiece& b, const OutlineFit& motion,
                                      double tolerance);

}  // namespace ripstop
