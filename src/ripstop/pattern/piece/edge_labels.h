#pragma once

#include <vector>

#include "ripstop/geometry/polygon.h"
#include "ripstop/model/piece/pattern_piece.h"

namespace ripstop {

/// The names of the pieces sewn to each edge, written along it inside the sew line, 8 to 3 mm high, the foot of the
/// letters to the edge; at the middle of where the mate lies, or beside it where something stands in the way. `taken`:
/// boxes to keep clear of. A name without room is left out. Requires a piece with edges.
std::vector<Label> place_edge_labels(const PatternPiece& piece, std::vector<Box> taken);

/// Do two boxes have a point in common? By the separating axis.
bool overlap(const Box& a, const Box& b);

}  // namespace ripstop
