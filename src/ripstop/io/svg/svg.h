#pragma once

#include <iosfwd>
#include <vector>

#include "ripstop/model/piece/pattern_piece.h"

namespace ripstop {

/// Writes the pieces as an SVG at true size: width and height are in mm, and one unit of the viewBox is 1 mm.
///
/// Each piece is a group, and a layer in Inkscape. Its id is the piece's name (blanks as `_`, numbered if taken);
/// `data-name` holds the name itself. The group has the layers `cut`, `sew`, `notch`, `internal`, `grain` and
/// `text`, unless they are empty. Colours say what to do: red is cut (the cut line, one closed path, and the
/// notches), blue is drawn (the sew line, one path per edge, the grain arrow, internal lines), black is text. A
/// path's `class` says what it is. An edge has `data-seam` (ids separated by blanks), `data-mate` (names separated
/// by commas), `data-type`, `data-length-mm` and `data-allowance-mm`. A piece without cut line is cut on the sew
/// line. The group `reference` holds a square of 100 mm. Lines are 0.2 mm wide, or 1/2500 of the sheet's shorter
/// side if that is more; only letters are filled.
///
/// SVG's y axis points down, so heights are measured from the top: the drawing shows the outside face, as the DXF
/// does, and letters are not mirrored. `shifts` is as in `make_sheet`.
void write_svg(std::ostream& out, const std::vector<PatternPiece>& pieces, const std::vector<Vec2>& shifts = {});

}  // namespace ripstop
