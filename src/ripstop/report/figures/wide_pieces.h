#pragma once

#include <string>
#include <vector>

#include "ripstop/model/piece/pattern_piece.h"

namespace ripstop {

/// A sentence for each fabric of whose pieces some are wider across the warp than its roll, allowances included: how
/// many, the widest of them, and what to do. None where every piece fits.
std::vector<std::string> too_wide_pieces(const PieceSet& set);

}  // namespace ripstop
