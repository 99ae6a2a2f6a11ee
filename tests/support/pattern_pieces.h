#pragma once

#include <string>
#include <vector>

#include "ripstop/model/piece/pattern_piece.h"

/// Pieces made by hand, as input of writers.
namespace ripstop::testing {

/// A closed band: `length` along the warp, `width` across, its two long sides bowed outwards by `bow`. It has a
/// cut line 12 mm outside the sew line, four edges, a notch on each long edge, a grain line, an internal line and
/// its name.
PatternPiece band(const std::string& name, double length, double width, double bow = 0);

/// Difficult input for every format: empty names and names beyond ASCII, a piece without cut line, one without
/// edges, an upright one, and one that is cut twice.
std::vector<PatternPiece> odd_pieces();

/// `count` small bands and their places on a sheet.
std::vector<PatternPiece> many_pieces(int count);

/// The length of the outline that is cut [m].
double cut_length(const PatternPiece& piece);

}  // namespace ripstop::testing
