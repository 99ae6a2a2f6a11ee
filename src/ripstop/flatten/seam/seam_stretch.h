#pragma once

#include <vector>

#include "ripstop/model/tile/envelope.h"

namespace ripstop {

/// The effect of the seam stretches on the edges of one tile.
struct TileStretch {
    std::vector<int> intervals;  ///< intervals at this tile, increasing
    /// #edges x #intervals [m]: with the stretches h of the intervals the edge lengths are target_lengths + reach h.
    Eigen::MatrixXd reach;
};

/// The seams of an envelope divided into intervals, each with one stretch for both of its sides. A flat edge in
/// seams, with target length t_e (`target_lengths`), has the length
///
///     l_e = t_e (1 + sum_i s_ei h_i),    s_ei the share of interval i in the edge's parts, sum_i s_ei = 1
///
/// An edge in no seam keeps its target length. Intervals end at the vertices of the side that has fewer of them. An
/// edge is straight and so has one stretch: if it belongs to two seams (a T-junction), all its intervals are united.
/// Both sides of a seam are then equally long from its start to its end and to each vertex of the side with more
/// vertices, and to the vertices of the other side up to the change of h within an edge. If both sides have the same
/// vertices, each edge is an interval.
struct SeamStretch {
    int count = 0;  ///< number of intervals
    std::vector<TileStretch> tiles = {};
};

/// Throws InputError if a part of a seam is not an edge of its tile, or if the lengths of the two sides differ by
/// more than 1e-9 (measure both on one curve). About O(parts).
SeamStretch find_seam_stretch(const Envelope& envelope);

}  // namespace ripstop
