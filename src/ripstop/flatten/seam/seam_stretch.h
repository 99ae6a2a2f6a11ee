#pragma once

#include <vector>

#include "ripstop/model/tile/envelope.h"

namespace ripstop {

/// What the stretches of an envelope's seams do to a tile's edges.
struct TileStretch {
    std::vector<int> intervals;  ///< those that touch the tile, increasing
    /// #edges x #intervals [m]: stretches h of the intervals make the edges target_lengths + reach h long.
    Eigen::MatrixXd reach;
};

/// The seams of an envelope cut into intervals, each of which has one stretch for both of its sides. A flat edge that
/// lies in seams, of target length t_e (`target_lengths`), is
///
///     l_e = t_e (1 + sum_i s_ei h_i),    s_ei the share of interval i in the edge's parts, sum_i s_ei = 1
///
/// long; an edge in no seam keeps its target. Intervals end at the vertices of the side that has fewer of them. An edge
/// is straight and so has one stretch: where it belongs to two seams (a T-junction), all intervals that it touches are
/// one. Then the sides of a seam are equally long from its start to its end and to each vertex of the side with more
/// vertices; at the other's, to the change of h within an edge. Where both sides have the same vertices, each edge is
/// an interval.
struct SeamStretch {
    int count = 0;  ///< intervals
    std::vector<TileStretch> tiles = {};
};

/// Throws InputError for a seam whose parts are none of its tiles' edges, or whose sides are not equally long to 1e-9
/// (both are to be measured on one curve). About O(parts).
SeamStretch find_seam_stretch(const Envelope& envelope);

}  // namespace ripstop
