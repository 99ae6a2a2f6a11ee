#pragma once

#include <vector>

#include "ripstop/model/envelope.h"

namespace ripstop {

/// What an interval of a seam does to a tile's edges.
struct TileStretch {
    std::vector<int> intervals;  ///< those that touch the tile, increasing
    /// #edges x #intervals [m]: how much of each boundary edge's target length lies in each interval, so that a stretch h
    /// of the intervals makes the edges target_lengths + reach h long.
    Eigen::MatrixXd reach;
};

/// The seams of an envelope cut into intervals, each of which has one stretch for both of its sides.
///
/// With the length of the flat edge e, target t_e (`target_lengths`), and h_i the stretch of interval i:
///
///     l_e = t_e + sum_i reach_ei h_i,    reach_ei = t_e / L_e * (what edge and interval share of the common curve)
///
/// L_e the edge's drawn length. From any point of a seam to any other the two sides are then equally long, to the stretch's
/// change within one edge, whatever vertices they have, and equal in all where they start and end; what lies in no seam
/// keeps its target. Intervals end at the vertices of the side that has fewer, of a chain's first and last edge only where
/// half of it or more belongs to the seam: every interval is one that an edge can feel.
struct SeamStretch {
    std::vector<int> first;          ///< seam s has the intervals first[s] to first[s + 1] - 1
    std::vector<TileStretch> tiles;  ///< in the order of the envelope
    int count() const { return first.back(); }
};

/// Throws InputError for a seam whose parts are none of its tiles' edges, or whose sides are not equally long to 1e-9 (both
/// are to be measured on one curve). About O(parts).
SeamStretch find_seam_stretch(const Envelope& envelope);

}  // namespace ripstop
