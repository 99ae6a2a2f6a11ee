#pragma once

#include <vector>

#include "ripstop/pattern/drawing/drawing_lines.h"

namespace ripstop {

/// Reports contours that cannot all be cut from one cloth, sew lines that are on no piece, and openings of sew
/// lines that are not cut.
///
/// Faults are: cut contours that cross by more than 0.1 mm or coincide; a cut contour inside another that is no
/// hole; and sew contours that protrude from every cut contour by more than 0.1 mm. A contour that contains a
/// text, a grain line or a sew line is a piece, and a contour inside a hole is a piece again. On numbered layers
/// each block is a sheet of its own, where inner contours are internal cuts. A sew line around an opening that
/// nothing cuts has lost it (`find_lost_opening`), unless it lies inside another sew line.
///
/// If no layers are known, nested lines may be anything. Lines of two layers that cross are then only noted, and
/// so are common sides of 1 mm or more. Reports stop after a thousand.
///
/// Sweeps over boxes, then compares contours whose boxes meet. At worst, every contour against every other.
void check_overlaps(DrawingSurvey& survey, const std::vector<FoundContour>& contours);

}  // namespace ripstop
