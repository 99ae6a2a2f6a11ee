#pragma once

#include <iosfwd>
#include <string>

#include "ripstop/model/pattern_drawing.h"

namespace ripstop {

/// Reads a DXF of anyone's: ASCII, Release 10 to 2018, in the file's own numbers.
///
/// LINE, POLYLINE and LWPOLYLINE with bulges, ARC and CIRCLE (a point a degree), POINT, TEXT, MTEXT, and blocks in blocks with
/// their shifts, scales, turns and arrays: each INSERT of the drawing itself is a group called as its block. Entities seen
/// from below are turned over as CAD does. Blocks that nothing inserts are groups without insertion. SPLINE, ELLIPSE and
/// all else that draws is `unread`; paper space is left out. Units: $INSUNITS, $MEASUREMENT and texts `Units: …`.
///
/// Throws InputError `NAME:LINE: …` for what is no DXF, is cut short, has a number that is none or beyond 1e9, inserts a block
/// into itself, or whose blocks in blocks hold more than some thousand points for each line of the file. O(size + points).
PatternDrawing read_dxf(std::istream& in, const std::string& name);

}  // namespace ripstop
