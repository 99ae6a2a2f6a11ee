#pragma once

#include <iosfwd>
#include <string>

#include "ripstop/model/piece/pattern_drawing.h"

namespace ripstop {

/// Reads a DXF of anyone's: ASCII, Release 10 to 2018, in the file's own numbers.
///
/// LINE, POLYLINE and LWPOLYLINE with bulges, ARC, CIRCLE, ELLIPSE, SPLINE and HELIX, POINT, TEXT, MTEXT, and blocks
/// in blocks with their shifts, scales, turns and arrays: each INSERT of the drawing itself is a group called as its
/// block. Curves are sampled to a chord error of 0.002 units, 0.05 mm in a drawing in inches, and at least a point a
/// degree. Planes stand in space as their extrusion directions say; paths are seen from above and keep the heights
/// between which they lie; texts turn with their block. Names are read in the code page of the file; those of blocks
/// and layers have no case. What a block has on layer 0 is on the layer of its INSERT. Blocks that nothing inserts
/// are groups without insertion.
///
/// What is invisible, on a layer that is off or frozen, or in a block that is inserted on a frozen one, and all else
/// that draws, is `unread`; paper space is left out. Units: $INSUNITS and texts `Units: …`.
///
/// Throws InputError `NAME:LINE: …` for what is no DXF, is cut short, has a number that is none or beyond 1e9,
/// inserts a block into itself, or whose blocks in blocks hold more than some thousand points for each line of the
/// file. O(size + points).
PatternDrawing read_dxf(std::istream& in, const std::string& name);

}  // namespace ripstop
