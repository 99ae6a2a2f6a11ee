#pragma once

#include <vector>

#include "ripstop/geometry/types.h"

namespace ripstop {

/// How the cut line goes round the corners at the ends of an edge.
enum class CornerRule {
    mitre,   ///< the allowances run on until they meet; on a sharp corner cut across at twice the larger from it
    square,  ///< cut across at the larger allowance from the corner
    fold,    ///< folded back about its sew line, the allowance ends where the piece does, its mirror image
    hem,     ///< as `fold`, and goes before it: a hem is folded when the seam beside it is sewn
};

/// One edge of a sew line and the cloth beyond it.
struct AllowedEdge {
    Points2 sew_line;      ///< #P x 2, both ends included, counter-clockwise round the piece
    double allowance = 0;  ///< [m], not negative
    CornerRule corner = CornerRule::mitre;
};

/// The cut line: everything within the sew line, and beyond each of its edges all that lies within its allowance at right
/// angles to the edge. Closed, counter-clockwise, first point not repeated (#P x 2).
///
/// At a corner between two edges: folded about the one whose rule is `hem` if only one says so; mitred between two hems;
/// else folded about one that says `fold`, the first of two; else square if either says `square`, else mitred. What would run
/// further than twice the wider allowance from the corner is not folded. Where the wider of two allowances runs past the
/// narrower (a corner nearly straight) the cut line steps from one to the other. Corners that turn inward take what the
/// edges give.
///
/// The offset of each segment is exact; where an edge bends outward its segments' offsets are joined by mitres, so the cut
/// line is `allowance / cos(turn / 2)` away at such a point (0.004 % more at a turn of a degree). It is the outer outline of
/// a union [Clipper 6.4, in steps of a tenth of a micrometre], so narrow notches of the sew line close instead of crossing.
/// Requires edges that close on themselves, in order. O(n log n).
Points2 make_cut_line(const std::vector<AllowedEdge>& edges);

}  // namespace ripstop
