#pragma once

#include "ripstop/model/marker.h"
#include "ripstop/model/pattern_piece.h"

namespace ripstop {

/// Puts in the place of a pattern's copies the pieces that it cuts (`PatternPiece::pattern`), in the order of the set, along
/// the roll: each then carries its own name, neighbours and notches. They have the same outline, so nothing moves; a piece
/// that is the pattern's mirror image is drawn as it is. Where the set has not all the pieces of a pattern, its copies keep
/// its drawing. O(#patterns x #placements + #placements x #outline).
void lay_own_pieces(const PieceSet& set, Marker& marker);

}  // namespace ripstop
