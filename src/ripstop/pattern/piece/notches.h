#pragma once

#include <vector>

#include "ripstop/model/plan/cut_plan.h"
#include "ripstop/pattern/piece/outline.h"
#include "ripstop/pattern/piece/seam_match.h"

namespace ripstop {

/// The spacing and depth of notches.
struct NotchOptions {
    double straight_spacing = 0.75;  ///< on a straight seam; the upper limit [m]
    double curved_spacing = 0.25;    ///< on a strongly curved seam; the lower limit [m]
    double turn = 0.15;              ///< of the seam between two notches, if the spacing stays within both limits [rad]
    double shortest_seam = 0.08;     ///< shorter seams get none [m]
    double depth = 0.006;            ///< of the cut; at most 0.4 of the allowance [m]
};

/// A place of a seam that both pieces mark.
struct SeamMark {
    double along = 0;  ///< along the seam's curve, from its start [m]
    int count = 1;     ///< 2: a double notch
};

/// The marks of a seam. They are evenly spaced in a measure of length and turn, so they are closer on curves. The
/// first mark from the start that `direction` names is double, so that a piece turned end for end does not fit; a
/// seam with room for one mark has it off its middle. Without a direction all marks are single, and a lone one is
/// in the middle. No mark lies within 1/8 of the spacing, or 30 mm, of the seam's ends, which are corners.
///
///     marks divide  integral of ds / h(s),  h = clamp(turn / curvature, curved_spacing, straight_spacing)
///
/// Here the curvature is the larger one of the two sides on the cloth. `tiles` must be flattened. O(#parts).
std::vector<SeamMark> seam_marks(const std::vector<FlatTile>& tiles, const Seam& seam, const NotchOptions& options = {},
                                 MarkDirection direction = MarkDirection::from_start);

/// The notches of every piece, in the order of `tiles`: those of its seams, by their `mark_directions`, and a
/// single one wherever one seam ends and the next begins on an edge, away from its corners (a T-junction). A piece
/// without edges has none.
std::vector<std::vector<PieceNotch>> make_notches(const CutPlan& plan, const std::vector<PieceOutline>& outlines,
                                                  const NotchOptions& options = {});

}  // namespace ripstop
