#pragma once

#include <iosfwd>
#include <string>

#include "ripstop/model/pattern_drawing.h"

namespace ripstop {

/// Reads an SVG of anyone's, in its user units with y up.
///
/// path (M L H V C S Q T Z, absolute and relative; curves in 16 chords; A is `unread`), line, polyline, polygon, rect, circle,
/// ellipse and text, in groups with transformations. A group is a `g` with an id, innermost first; the layer is the class of
/// what is drawn, else the nearest Inkscape layer. What is only defined (defs, symbol, clipPath, …) is not drawn; `use`,
/// image and all else is `unread`. Unit: width (or height) and viewBox; without a unit in them none is stated.
///
/// Throws InputError `NAME: byte N: …` for what is no XML, `NAME: …` for another root than svg, a path or number that cannot be
/// read, elements more than 256 deep, and coordinates beyond 1e9. O(size).
PatternDrawing read_svg(std::istream& in, const std::string& name);

}  // namespace ripstop
