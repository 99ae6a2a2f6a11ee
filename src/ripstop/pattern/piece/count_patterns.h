#pragma once

#include <string>
#include <vector>

#include "ripstop/model/piece/pattern_piece.h"

namespace ripstop {

/// The number of copies as the pattern states it: `cut 12 + 12 mirrored`; empty for a single copy.
std::string cut_count(const PatternPiece& piece);

/// Recounts the copies of each pattern after pieces were removed. The first of equal pieces is the pattern; the
/// others are cut by it, turned over if they are mirror images. A label that states the count is updated, or dropped
/// if the piece is cut once.
void count_patterns(std::vector<PatternPiece>& pieces);

}  // namespace ripstop
