#pragma once

#include <array>

#include "ripstop/model/plan/seam_walk.h"
#include "ripstop/model/tile/seam.h"

namespace ripstop {

/// How far side b is ahead of side a at `s` along the seam's curve, linear between its notches [m].
double drift_at(const SeamWalk& walk, double s);

/// The start and end of a side's part on its boundary edge, as shares of that edge; `drawn` is the edge's length
/// as drawn [m]. A seam begins at the end of its first edge and ends at the start of its last; one within a single
/// edge is centred on it.
std::array<double, 2> share_of_edge(const SeamSide& side, std::size_t part, double drawn);

}  // namespace ripstop
