#pragma once

#include "ripstop/model/piece/marker.h"
#include "ripstop/model/piece/pattern_piece.h"

namespace ripstop {

/// The piece at its place on the roll: turned, mirrored and shifted. The name states which copy it is. All
/// outlines are counter-clockwise, letters are never mirrored or upside down, and lines keep their order. A mirror
/// image says so in its name and on its label. On a copy, `cut 24` becomes `2/24`; the count disappears if every
/// piece is laid by itself.
PatternPiece laid_piece(const PatternPiece& piece, const Placement& placement);

}  // namespace ripstop
