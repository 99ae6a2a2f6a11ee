#pragma once

#include <vector>

#include "ripstop/geometry/polygon.h"
#include "ripstop/model/piece/pattern_piece.h"

namespace ripstop {

/// Writes the names of the pieces sewn to each edge along it, inside the sew line, with 8 to 3 mm high letters
/// whose feet point to the edge. A name stands at the middle of its mate, or beside it if something is in the way.
/// `taken` holds boxes to avoid. A name without room is left out. Requires a piece with edges.
std::vector<Label> place_edge_labels(const PatternPiece& piece, std::vector<Box> taken);

/// True if two boxes share a point, by the separating axis theorem.
bool overlap(const Box& a, const Box& b);

}  // namespace ripstop
