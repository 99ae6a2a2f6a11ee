#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "ripstop/model/piece/pattern_piece.h"

namespace ripstop {

struct DxfOptions {
    std::string dialect = "cam";  ///< a name of `dxf_dialects`
    std::string style = {};       ///< what the pieces belong to
    std::string revision = {};    ///< of the patterns
    std::string date = {};        ///< of their making, YYYY-MM-DD; none: none is stated, so the same bytes every day
    std::string grain_axis = {};  ///< x or y, along which the warp runs; none: the dialect's own
};

/// Writes the pieces as a DXF: millimetres, ASCII, CR LF, four decimals, Release 12 (`clo`: 10).
///
/// Dialect `cam`: one closed POLYLINE a contour; layers CUT (red), SEW (green), NOTCH (a LINE from the cut line
/// inwards, two for a double one), GRAIN (three LINEs: shaft and barbs), INTERNAL (open polylines: drawn, not cut),
/// TEXT and REF. REF holds a square of 100 mm with that text and `Units: METRIC`, right of the pieces, to check the
/// size by. $INSUNITS and $MEASUREMENT say millimetres too; Release 12 does not know the first, and readers that do not
/// either skip it.
///
/// The others: a BLOCK a piece, inserted at the origin, on the layers 1 cut line and the piece's texts, 2 corners, 3
/// the other points of the contours, 4 notches, 7 grain, 8 internal lines, 14 sew line, 15 labels; the unit is the text
/// `Units: METRIC`. A contour without corners is one closed POLYLINE everywhere. See `DxfDialect` and docs/dialects.md.
///
/// Corners that coincide as written are written once. Names lose what is not ASCII (`ascii_text`). `shifts` as in
/// `make_sheet`. Where the grain runs along +y the whole drawing is turned by a quarter, its lower left corner kept.
/// Throws InputError for a dialect or an axis that is not known.
void write_dxf(std::ostream& out, const std::vector<PatternPiece>& pieces, const std::vector<Vec2>& shifts = {},
               const DxfOptions& options = {});

}  // namespace ripstop
