#pragma once

#include <vector>

#include "ripstop/pattern/drawing/drawing_lines.h"

namespace ripstop {

/// Names contours that cannot all be cut from one cloth, sew lines that are on none of the pieces, and openings of
/// sew lines that are not cut.
///
/// Wrong are cut contours that cross by more than 0.1 mm or lie on each other, one within another that is no hole (a
/// text, a grain line or a sew line in it makes a piece of it; what lies in a hole is a piece again), and sew
/// contours that reach out of every cut contour by more than 0.1 mm. On numbered layers each block is a sheet of its
/// own, where contours within others are internal cuts. A sew line round an opening that nothing cuts has lost it
/// (`find_lost_opening`), unless it lies within another one. Where no layers are known lines within each other may be
/// anything, and lines of two layers that cross are only noted, and so are sides of 1 mm and more that two contours
/// have in common. After a thousand of them no more are told.
///
/// Boxes by a sweep; then only contours whose boxes meet. At worst every contour against every other.
void check_overlaps(DrawingSurvey& survey, const std::vector<FoundContour>& contours);

}  // namespace ripstop
