#pragma once

#include <iosfwd>
#include <string>

#include "ripstop/model/piece/pattern_piece.h"

namespace ripstop {

/// cut/pieces.json: the pieces as `make_pieces` made them, so that they can be written in any dialect and laid on the
/// roll without solving again. Coordinates and lengths in metres, keys end in `_m`; numbers read back to the same
/// doubles.
std::string pieces_json(const PieceSet& set);

/// Throws InputError naming the file and the place for anything but what `pieces_json` writes: an edge that is none of
/// the outline's, a coordinate that is not finite or beyond a kilometre, a set without fabric, a name that stands twice
/// or that nothing has.
PieceSet read_pieces(std::istream& in, const std::string& name);

}  // namespace ripstop
