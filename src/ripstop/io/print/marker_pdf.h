#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "ripstop/model/piece/marker.h"

namespace ripstop {

/// Writes a marker as a PDF to lay it by: the roll in small on A4 pages, in strips of a round scale (1:40 for cloth of
/// 1.5 m), four a page, with metres from its start, joins, and every piece with its name and grain. Cut lines are red.
/// The pieces lie in true size in the marker's DXF, SVG and HPGL.
///
/// `pieces` as they lie (`placed_piece`), one for each of the marker's placements; `title` on every page.
void write_marker_pdf(std::ostream& out, const Marker& marker, const std::vector<PatternPiece>& pieces,
                      const std::string& title);

}  // namespace ripstop
