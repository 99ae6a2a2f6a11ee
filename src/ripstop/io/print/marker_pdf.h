#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "ripstop/model/piece/marker.h"
#include "ripstop/model/piece/pattern_piece.h"

namespace ripstop {

/// Writes a marker as a PDF that shows how to lay the pieces. The roll is drawn in strips at a round scale (1:40
/// for cloth of 1.5 m), four on each A4 page, with metres from its start, joins, and every piece with its name and
/// grain. Cut lines are red. The marker's DXF, SVG and HPGL files have the pieces at true size.
///
/// `pieces` are in place (`laid_piece`), one for each placement of the marker. Every page shows `title`.
void write_marker_pdf(std::ostream& out, const Marker& marker, const std::vector<PatternPiece>& pieces,
                      const std::string& title);

}  // namespace ripstop
