#pragma once

#include <string>

#include "ripstop/model/piece/marker.h"
#include "ripstop/model/piece/pattern_piece.h"

namespace ripstop {

/// Metres of thread per metre of a row of stitching, needle and bobbin together, for a lockstitch in light cloth.
inline constexpr double thread_per_row = 3;

/// The text of bom.csv, the bill of materials. Each line has a `kind`; fields that do not apply are empty:
///
///     cloth   a fabric and colour: net_m2 of its pieces; with markers gross_m2, running_m at roll_width_mm,
///             waste_pct = 1 - net/gross
///     seam    a seam type: length_m sewn, thread_m = rows x length x `thread_per_row`, tape_m if it has a tape
///     piece   a pattern with its quantity and mirrored quantity, net_m2 of one
///
/// A seam is counted once, half its length on either piece; the parts of edges in no seam count in full. Every
/// tile has its piece in the set, even if another's pattern cuts it (quantity 0), so that the types of all seams
/// are counted. `markers` may be null: nothing was nested. A cloth with a piece that could not be laid has no
/// gross.
std::string bom_csv(const PieceSet& set, const Markers* markers);

}  // namespace ripstop
