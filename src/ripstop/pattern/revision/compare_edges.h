#pragma once

#include <vector>

#include "ripstop/model/piece/pattern_piece.h"
#include "ripstop/model/piece/piece_change.h"
#include "ripstop/pattern/revision/fit_outline.h"

namespace ripstop {

/// The edges of `a` that are others in `b`, each beside the one that lies where the motion takes it: of all the
/// numberings that keep their order, that whose corners and middles lie nearest. None where there are not as many.
/// Mates are told by the names of their pieces and the lengths sewn to them, not by the ids of seams. Lengths that
/// differ by no more than `tolerance` [m] are the same. O(#edges^2).
std::vector<EdgeChange> compare_edges(const PatternPiece& a, const PatternPiece& b, const OutlineFit& motion,
                                      double tolerance);

}  // namespace ripstop
