#pragma once

#include <iosfwd>
#include <string>

#include "ripstop/model/piece/pattern_drawing.h"

namespace ripstop {

/// Reads an SVG from any program as browsers do. Coordinates are in user units of the root with y up. (If
/// `preserveAspectRatio="none"` stretches the page, they are in the units along its width.)
///
/// Reads shapes (`svg_shape`) and text (`svg_text`) in g, a, switch, nested svg and symbols, and wherever a `use`
/// draws them, with all transforms and styles. Groups are the g, svg and use elements with an id, innermost first.
/// The layer is the class of the element, or of its use, else the nearest Inkscape layer. Definitions (defs,
/// symbol, clipPath, …) and hidden elements are not drawn. Curves are sampled by `SvgScale::sampling`, after all
/// transforms. The unit comes from `svg_scale`, or from a length in mm in a file without viewBox. Everything else
/// that is drawn, and what a clip cuts off, is listed in `unread` with the reason, its line and its place.
///
/// Throws InputError `NAME: byte N: …` if the file is not XML, its root is not svg, a path or transform is
/// malformed, elements are nested more than 256 deep, coordinates exceed 1e9, uses draw more than 200,000
/// elements, or curves have more than 8 million points. O(elements x (rules + clips) + points).
PatternDrawing read_svg(std::istream& in, const std::string& name);

}  // namespace ripstop
