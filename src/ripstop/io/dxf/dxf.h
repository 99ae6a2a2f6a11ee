#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "ripstop/model/piece/pattern_piece.h"

namespace ripstop {

struct DxfOptions {
    std::string dialect = "cam";  ///< a name of `dxf_dialects`
    std::string style = {};       ///< name of the style (the input) that the pieces belong to
    std::string revision = {};    ///< of the patterns
    std::string date = {};        ///< of the patterns, YYYY-MM-DD; empty: not written, so the file is the same
                                  ///< every day
    std::string grain_axis = {};  ///< axis along which the warp runs, x or y; empty: the dialect's default
};

/// Writes the pieces as ASCII DXF of Release 12 (`clo`: 10), in millimetres with four decimals and CR LF.
///
/// Dialect `cam`: each contour is a closed POLYLINE. Layers are CUT (red), SEW (green), NOTCH (a LINE from the cut
/// line inwards, two for a double notch), GRAIN (three LINEs: shaft and barbs), INTERNAL (open polylines: drawn,
/// not cut), TEXT and REF. REF holds a square of 100 mm to the right of the pieces, to check the size by, with
/// that text and `Units: METRIC`. $INSUNITS and $MEASUREMENT state millimetres too; $INSUNITS is newer than
/// Release 12, and readers that do not know it skip it.
///
/// Other dialects: each piece is a BLOCK, inserted at the origin. Layers are 1 cut line and the piece's texts, 2
/// corners, 3 the other points of the contours, 4 notches, 7 grain, 8 internal lines, 14 sew line, 15 labels. The
/// text `Units: METRIC` states the unit. A contour without corners is one closed POLYLINE in every dialect. See
/// `DxfDialect` and docs/dialects.md.
///
/// Corners that coincide after rounding are written once. Names are reduced to ASCII (`ascii_text`). `shifts` is
/// as in `make_sheet`. If the grain runs along +y, the whole drawing is turned by 90 degrees and keeps its lower
/// left corner. Throws InputError for an unknown dialect or axis.
void write_dxf(std::ostream& out, const std::vector<PatternPiece>& pieces, const std::vector<Vec2>& shifts = {},
               const DxfOptions& options = {});

}  // namespace ripstop
