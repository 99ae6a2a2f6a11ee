#pragma once

#include "ripstop/model/piece/pattern_piece.h"

namespace ripstop {

/// The piece moved by `shift` [m]. If `turned`, it is first rotated by 90 degrees counter-clockwise with
/// everything on it, so that its warp runs along +y. Lengths stay bitwise the same.
PatternPiece moved_piece(PatternPiece piece, const Vec2& shift, bool turned = false);

}  // namespace ripstop
