#pragma once

#include <vector>

#include "ripstop/geometry/types.h"
#include "ripstop/model/piece/pattern_piece.h"
#include "ripstop/pattern/cut/sew_contour.h"

namespace ripstop {

/// A cut line, and the places where it has less than the allowance.
struct CutLine {
    Points2 points;                       ///< closed, counter-clockwise, first point not repeated (#P x 2)
    std::vector<MetAllowances> met = {};  ///< by edge, then by the other edge; each pair once
};

/// The cut line: the outline of everything within the sew line and, beyond each edge, within its allowance at
/// right angles to the edge.
///
/// Corners between two edges follow their rules. A single `hem` is folded; two hems are mitred. Otherwise the
/// first `fold` is folded; otherwise the corner is square if either says `square`, else mitred. A fold that would
/// extend more than twice the wider allowance from the corner is not made. Where the wider of two allowances
/// passes the narrower (a corner that is nearly straight), the cut line steps from one to the other. Corners that
/// turn inward get what the edges give, and small notches close instead of crossing (`SewContour::is_apart` says
/// how small).
///
/// Otherwise the cut line keeps the topology of the sew line. Where the allowances of facing parts do not fit
/// between them, each gets what `AllowanceFit` leaves it, so a slit, a ring that is cut open or the neck of an
/// opening is still cut. `met` says where, and how wide the gap is; losses below 0.05 mm are ignored.
///
/// The offset of each segment is exact. Where an edge bends outward, the offsets are joined by mitres, so the cut
/// line is `allowance / cos(turn / 2)` away at such a point (0.004 % more at a turn of one degree). The result is
/// the outer outline of a union [Clipper 6.4, in steps of 0.1 micrometre]. Between two facing parts it is accurate
/// to 0.01 mm. Requires edges that form a closed line, in order. O(n log n), plus O(length / allowance) where
/// parts face each other.
CutLine make_cut_line(const std::vector<AllowedEdge>& edges);

}  // namespace ripstop
