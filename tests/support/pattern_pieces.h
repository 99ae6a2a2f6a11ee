#pragma once

#include <string>
#include <vector>

#include "ripstop/model/piece/pattern_piece.h"

/// Pieces made by hand, for what writes them.
namespace ripstop::testing {

/// A closed band: `length` along the warp, `width` across, its two long sides bowed outwards by `bow`, with a cut line
/// 12 mm outside the sew line, four edges, a notch on each long edge, a grain line, an internal line and its name.
PatternPiece band(const std::string& name, double length, double width, double bow = 0);

/// What every format has to take: names outside ASCII and empty ones, a piece without cut line, one without edges, one that
/// is upright, one cut twice.
std::vector<PatternPiece> odd_pieces();

/// `count` small bands and where they lie on a sheet.
std::vector<PatternPiece> many_pieces(int count);

/// Length of the outline that is cut [m].
double cut_length(const PatternPiece& piece);

}  // namespace ripstop::testing
