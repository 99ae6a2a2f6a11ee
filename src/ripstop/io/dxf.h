#pragma once

#include <iosfwd>
#include <vector>

#include "ripstop/model/pattern_piece.h"

namespace ripstop {

/// Writes the pieces as a DXF for cutters and CAD: Release 12 (AC1009), millimetres, ASCII, CRLF.
///
/// One closed POLYLINE a contour; layers CUT (red), SEW (green), NOTCH (a LINE from the cut line inwards, two for a double
/// one), GRAIN (three LINEs: shaft and barbs), INTERNAL (open polylines: drawn, not cut), TEXT and REF. REF holds a
/// square of 100 mm with that text, right of the pieces, to check the size by. $INSUNITS and $MEASUREMENT say millimetres
/// too; Release 12 does not know the first, and readers that do not either skip it. Four decimals; corners that coincide
/// at that precision are written once. Names lose what is not ASCII (`ascii_text`). `shifts` as in `make_sheet`.
void write_dxf(std::ostream& out, const std::vector<PatternPiece>& pieces, const std::vector<Vec2>& shifts = {});

}  // namespace ripstop
