#pragma once

#include <iosfwd>
#include <vector>

#include "ripstop/model/piece/pattern_piece.h"

namespace ripstop {

/// Writes the pieces as an SVG in true size: width and height in mm and a viewBox in which one unit is 1 mm.
///
/// One group a piece with the piece's name as id (blanks as `_`, numbered where taken; the name itself in `data-name`),
/// a layer to Inkscape; in it the layers `cut`, `sew`, `notch`, `internal`, `grain` and `text`, as far as there is
/// something in them. Colours say what is done: cut is red (the cut line, one closed path, and the notches), drawn is
/// blue (the sew line, a path an edge, the grain arrow, internal lines), letters are black. A path's `class` says which
/// it is. An edge has `data-seam` (ids between blanks) and `data-mate` (names between commas), `data-type`,
/// `data-length-mm`, `data-allowance-mm`. A piece without cut line is cut on the sew line. A square of 100 mm stands in
/// the group `reference`. Lines of 0.2 mm (1/2500 of the sheet's shorter side where that is more), nothing filled but
/// letters. SVG's y runs down, so heights are measured from the top: what is seen is the outside face, as in the DXF,
/// and letters read the right way. `shifts` as in `make_sheet`.
void write_svg(std::ostream& out, const std::vector<PatternPiece>& pieces, const std::vector<Vec2>& shifts = {});

}  // namespace ripstop
