#pragma once

#include <iosfwd>
#include <string>

#include "ripstop/model/piece/pattern_drawing.h"

namespace ripstop {

/// Reads an SVG of anyone's as browsers do, in the user units of its root with y up (a page that is stretched by
/// `preserveAspectRatio="none"` in those along its width).
///
/// Shapes (`svg_shape`) and text (`svg_text`) in g, a, switch, nested svg and symbols, and wherever a `use` draws them,
/// with the transforms and styles on the way. A group is a g, svg or use with an id, innermost first; the layer is the
/// class of what is drawn, or of its use, else the nearest Inkscape layer. What is only defined (defs, symbol,
/// clipPath, …) is not drawn, nor is what is hidden. Curves are sampled by `SvgScale::sampling`, after all transforms;
/// units by `svg_scale`, and without any a length in mm in a file without viewBox. Whatever else is drawn is `unread`,
/// with why, its line and place; what is cut off by a clip too.
///
/// Throws InputError `NAME: byte N: …` for what is no XML, another root than svg, a path or transform that cannot be
/// read, elements more than 256 deep, coordinates beyond 1e9, uses that draw more than 200,000 elements, curves of more
/// than 8 million points. O(elements x (rules + clips) + points).
PatternDrawing read_svg(std::istream& in, const std::string& name);

}  // namespace ripstop
