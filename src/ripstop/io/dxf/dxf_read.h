#pragma once

#include <iosfwd>
#include <string>

#include "ripstop/model/piece/pattern_drawing.h"

namespace ripstop {

/// Reads a DXF from any program: ASCII, Release 10 to 2018, in the file's own unit.
///
/// Entities. LINE, POLYLINE and LWPOLYLINE with bulges, ARC, CIRCLE, ELLIPSE, SPLINE, HELIX, POINT, TEXT and
/// MTEXT, also in nested blocks with their shifts, scales, rotations and arrays. Each INSERT of the drawing itself
/// is a group with the block's name. Curves are sampled with a chord error of 0.002 units (0.05 mm in a drawing in
/// inches) and at least one point per degree. Extrusion directions orient planes in space. Paths are seen from
/// above, and the range of their heights is kept. Texts rotate with their block.
///
/// Names. They are read in the file's code page. Names of blocks and layers ignore case. Entities of a block on
/// layer 0 take the layer of their INSERT. Blocks without an INSERT are groups without insertion.
///
/// `unread` lists entities that are invisible, on a layer that is off or frozen, or in a block that is inserted on
/// a frozen layer, and all other entities that draw. Paper space is skipped. Units come from $INSUNITS and from
/// texts `Units: …`.
///
/// Throws InputError `NAME:LINE: …` if the file is not DXF or is cut short, has a malformed number or one beyond
/// 1e9, inserts a block into itself, or if nested blocks hold more than some thousand points for each line of the
/// file. O(size + points).
PatternDrawing read_dxf(std::istream& in, const std::string& name);

}  // namespace ripstop
