#pragma once

#include <string>
#include <vector>

#include "ripstop/model/piece/pattern_piece.h"

namespace ripstop {

/// A sentence for each fabric with pieces that are wider across the warp than its roll, allowances included: how
/// many there are, the widest of them, and what to do. Empty if every piece fits.
std::vector<std::string> too_wide_pieces(const PieceSet& set);

}  // namespace ripstop
