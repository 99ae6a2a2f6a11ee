#pragma once

#include <iosfwd>
#include <string>

#include "ripstop/model/piece/pattern_piece.h"

namespace ripstop {

/// The text of cut/pieces.json: the pieces as `make_pieces` returned them, so that they can be written in any
/// dialect and nested without solving again. Coordinates and lengths are in metres; their keys end in `_m`.
/// Numbers read back as the same doubles.
std::string pieces_json(const PieceSet& set);

/// Reads what `pieces_json` wrote. Throws InputError with the file and the place for anything else: an edge that
/// is not on the outline, a coordinate that is not finite or beyond a kilometre, a set without fabric, a duplicate
/// or unknown name.
PieceSet read_pieces(std::istream& in, const std::string& name);

}  // namespace ripstop
