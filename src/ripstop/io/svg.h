#pragma once

#include <iosfwd>
#include <vector>

#include "ripstop/model/pattern_piece.h"

namespace ripstop {

/// Writes the pieces as an SVG in true size: width and height in mm and a viewBox in which one unit is 1 mm.
///
/// One group a piece with the piece's name as id (blanks as `_`, numbered where taken; the name itself in `data-name`),
/// in it the sew line (red), the grain arrow (blue) and the label (black); a square of 100 mm in the group `reference`.
/// Lines of 0.2 mm (1/2500 of the sheet where that is more), nothing filled but letters. SVG's y runs down, so heights are measured from the top: what is seen is the
/// outside face, as in the DXF, and letters read the right way. `shifts` as in `make_sheet`.
void write_svg(std::ostream& out, const std::vector<PatternPiece>& pieces, const std::vector<Vec2>& shifts = {});

}  // namespace ripstop
