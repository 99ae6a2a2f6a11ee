#pragma once

#include <vector>

#include "ripstop/model/plan/cut_plan.h"
#include "ripstop/pattern/piece/outline.h"
#include "ripstop/pattern/piece/seam_match.h"

namespace ripstop {

/// How far apart notches are and how deep they are cut.
struct NotchOptions {
    double straight_spacing = 0.75;  ///< on a straight seam, at most [m]
    double curved_spacing = 0.25;    ///< on a strongly curved one, at least [m]
    double turn = 0.15;              ///< of the seam between two notches, where that lies between the two [rad]
    double shortest_seam = 0.08;     ///< shorter ones need none [m]
    double depth = 0.006;            ///< of the cut; never more than 0.4 of the allowance [m]
};

/// A place of a seam that is marked on both pieces.
struct SeamMark {
    double along = 0;  ///< the seam's curve from its start [m]
    int count = 1;     ///< 2: a double notch
};

/// Where a seam is marked: equally far apart in what its curve turns and runs, so more closely on curves. The first
/// mark from where `direction` begins is double, so that a piece turned end for end does not fit; a seam with room for
/// one mark has it off its middle. Without direction all are single, and a lone one in the middle. None lies within 1/8
/// of the spacing, or 30 mm, of the seam's ends, which are corners.
///
///     marks divide  integral of ds / h(s),  h = clamp(turn / curvature, curved_spacing, straight_spacing)
///
/// with the larger curvature of the two sides on the cloth. `tiles` are flattened. O(#parts).
std::vector<SeamMark> seam_marks(const std::vector<FlatTile>& tiles, const Seam& seam, const NotchOptions& options = {},
                                 MarkDirection direction = MarkDirection::from_start);

/// The notches of every piece, in the order of `tiles`: those of its seams in their `mark_directions`, and a single one
/// wherever on an edge, away from its corners, one seam ends and the next begins (a T-junction). A piece without edges
/// has none.
std::vector<std::vector<PieceNotch>> make_notches(const CutPlan& plan, const std::vector<PieceOutline>& outlines,
                                                  const NotchOptions& options = {});

}  // namespace ripstop
