#pragma once

#include <string>
#include <vector>

#include "ripstop/model/piece/pattern_piece.h"
#include "ripstop/model/plan/cut_plan.h"

namespace ripstop {

/// A fault of a piece's cut line.
struct CutFault {
    std::string message;     ///< one sentence, without the piece's name
    Vec2 at = Vec2::Zero();  ///< on the piece [m]
    double value = 0;        ///< [mm]: length of sew line that is affected, or error of the cut line
};

/// Checks the cut line of a piece against its sew line and allowances, however it was made:
///
/// - The cut line is one closed line, counter-clockwise, that neither crosses nor touches itself.
/// - It winds once round every point of the sew line, and the sew line round none of it.
/// - At each place of an edge, the cut line is at the distance of the allowance, perpendicular to the edge. It may be
///   farther only where the allowance of a part that is not apart covers the place (`SewContour::is_apart`: a corner
///   that turns inward). It may be nearer only where `PatternPiece::met` says so, by that amount, and at the ends of an
///   edge, where hems are folded.
///
/// The tolerance is 0.06 mm. Tests places half an allowance apart and the points of both lines. An opening that is
/// not cut, a notch that is filled in, and a part of the sew line without cloth are faults, one for each edge. A
/// piece without edges or allowances is cut along its sew line, and passes. About O(length / allowance + n log n),
/// plus O(n) for each place with a wrong allowance.
std::vector<CutFault> check_cut_line(const PatternPiece& piece);

/// The sentence on allowances that meet: edges, seam types, length, widths, gap, and what is left.
std::string met_text(const PatternPiece& piece, const MetAllowances& met);

/// Adds faults of the pieces' cut lines to the verdicts of their tiles, each with its place in space. Faults found
/// by `check_cut_line` have the code `cut_line` and a value in mm. Allowances that meet have the code
/// `allowances_meet`; the value is the gap, the limit both allowances [mm]. If `allowance_fit` is set, allowances
/// that meet and keep at least 1 mm pass; the returned sentences say what was taken, one for each pattern. Pieces
/// that overlap themselves or have no proper flattening keep their own findings and get no others. Runs on
/// `threads` threads (0: one per core).
std::vector<std::string> judge_cut_lines(CutPlan& plan, const std::vector<PatternPiece>& pieces, bool allowance_fit,
                                         int threads = 0);

/// The faults that `check_cut_line` finds in pieces that were read from a file, as sentences with the pieces'
/// names.
std::vector<std::string> cut_line_faults(const std::vector<PatternPiece>& pieces, int threads = 0);

}  // namespace ripstop
