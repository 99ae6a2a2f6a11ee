#pragma once

#include <vector>

#include "ripstop/geometry/types.h"
#include "ripstop/model/piece/pattern_piece.h"
#include "ripstop/pattern/cut/sew_contour.h"

namespace ripstop {

/// What is cut, and where it keeps less than what is allowed.
struct CutLine {
    Points2 points;                       ///< closed, counter-clockwise, first point not repeated (#P x 2)
    std::vector<MetAllowances> met = {};  ///< by edge, then by the edge that is met; each pair once
};

/// The cut line: everything within the sew line, and beyond each of its edges all that lies within its allowance at
/// right angles to the edge.
///
/// At a corner between two edges: folded about the one whose rule is `hem` if only one says so; mitred between two
/// hems; else folded about one that says `fold`, the first of two; else square if either says `square`, else mitred.
/// What would run further than twice the wider allowance from the corner is not folded. Where the wider of two
/// allowances runs past the narrower (a corner nearly straight) the cut line steps from one to the other. Corners that
/// turn inward take what the edges give, and small notches close instead of crossing (`SewContour::is_apart` says how
/// small).
///
/// Else it keeps the topology of the sew line: where the allowances of parts that face each other do not fit between
/// them, each keeps what `AllowanceFit` leaves it, so that a slit, a ring that is cut open or the neck of an opening
/// stays cut. `met` says where, and how wide the gap is; less than 0.05 mm that is missing is none.
///
/// The offset of each segment is exact; where an edge bends outward its segments' offsets are joined by mitres, so the
/// cut line is `allowance / cos(turn / 2)` away at such a point (0.004 % more at a turn of a degree). It is the outer
/// outline of a union [Clipper 6.4, in steps of a tenth of a micrometre]. Between two parts it is right to 0.01 mm.
/// Requires edges that close on themselves, in order. O(n log n); where parts face each other, O(length / allowance)
/// more.
CutLine make_cut_line(const std::vector<AllowedEdge>& edges);

}  // namespace ripstop
