#pragma once

#include <string>

#include "ripstop/model/piece/marker.h"
#include "ripstop/model/piece/pattern_piece.h"

namespace ripstop {

/// Metres of thread that a metre of a row of stitching takes, needle and bobbin together: a lockstitch in light cloth.
inline constexpr double thread_per_row = 3;

/// bom.csv: what to order. A line each, told apart by `kind`, fields that mean nothing to it empty:
///
///     cloth   a fabric and colour: net_m2 of its pieces; with markers gross_m2, running_m at roll_width_mm,
///             waste_pct = 1 - net/gross
///     seam    a seam type: length_m sewn, thread_m = rows x length x `thread_per_row`, tape_m where it takes a tape
///     piece   a pattern with its quantity and mirrored quantity, net_m2 of one
///
/// A seam is counted once: half its length on either piece; what of an edge is in no seam, whole. Every tile has its
/// piece in the set, also where another's pattern cuts it (quantity 0), so that its seams' types are its own. `markers`
/// null: nothing was laid. A cloth of which a piece could not be laid has no gross.
std::string bom_csv(const PieceSet& set, const Markers* markers);

}  // namespace ripstop
