#pragma once

#include <string>
#include <vector>

#include "ripstop/model/piece/pattern_piece.h"
#include "ripstop/model/plan/cut_plan.h"

namespace ripstop {

/// Something that is wrong with a piece's cut line.
struct CutFault {
    std::string message;     ///< one sentence, without the piece's name
    Vec2 at = Vec2::Zero();  ///< on the piece [m]
    double value = 0;        ///< [mm]: how much of the sew line is concerned, or how far off the cut line is
};

/// Holds the cut line of a piece to its sew line and allowances, however it was made:
///
/// - The cut line is one closed line, counter-clockwise, that neither crosses nor touches itself.
/// - It winds once round every point of the sew line, and the sew line round none of it.
/// - Each place of an edge has the cut line at right angles to it at its allowance. The cut line is further away only
///   where the allowance of a part that is not apart covers the place (`SewContour::is_apart`: a corner that turns
///   inward). It is nearer only where `PatternPiece::met` says so, by no more than that, and at the ends of an edge,
///   where hems are folded.
///
/// Checked to 0.06 mm, at places half an allowance apart and at the points of both lines. An opening that is not cut, a
/// notch that is filled in, a part of the sew line without cloth are breaches, one for each edge. A piece without edges
/// or allowances is cut along its sew line, and passes. About O(length / allowance + n log n), and O(n) for each place
/// that has not its allowance.
std::vector<CutFault> check_cut_line(const PatternPiece& piece);

/// What is said of allowances that meet: edges, how they are sewn, length, widths, gap, and what is left.
std::string met_text(const PatternPiece& piece, const MetAllowances& met);

/// Takes what is wrong with the pieces' cut lines into the verdicts of their tiles: what `check_cut_line` finds (code
/// `cut_line`, the value in mm) and allowances that meet (code `allowances_meet`; the value is the gap, the limit
/// both allowances [mm]), each with its place in space. Where `allowance_fit`, allowances that meet and keep at least
/// 1 mm pass, and the sentences that are returned say what was taken, one for each pattern. Pieces that lie on
/// themselves or have no flattening to speak of have their own findings and no other. On `threads` threads (0: one a
/// core).
std::vector<std::string> judge_cut_lines(CutPlan& plan, const std::vector<PatternPiece>& pieces, bool allowance_fit,
                                         int threads = 0);

/// What `check_cut_line` finds of pieces that were read again, as sentences with the piece's name.
std::vector<std::string> cut_line_faults(const std::vector<PatternPiece>& pieces, int threads = 0);

}  // namespace ripstop
