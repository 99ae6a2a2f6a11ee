#pragma once

#include "ripstop/model/piece/pattern_piece.h"

namespace ripstop {

/// The piece with everything on it turned by a quarter counter-clockwise where `turned` says so, so that its warp runs
/// along +y, and then moved by `shift` [m]. Lengths stay the same to the last bit.
PatternPiece placed(PatternPiece piece, const Vec2& shift, bool turned = false);

}  // namespace ripstop
