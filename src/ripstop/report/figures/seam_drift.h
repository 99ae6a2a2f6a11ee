#pragma once

#include <array>

#include "ripstop/model/plan/seam_walk.h"
#include "ripstop/model/tile/seam.h"

namespace ripstop {

/// How far side b is ahead of side a at `s` along the seam's curve, in proportion between its notches [m].
double drift_at(const SeamWalk& walk, double s);

/// From where to where a part of a side lies on its boundary edge, as shares of it; `drawn`: how long that edge is
/// drawn [m]. A seam begins at the end of its first edge and ends at the start of its last; one within a single edge is
/// taken to lie about its middle.
std::array<double, 2> share_of_edge(const SeamSide& side, std::size_t part, double drawn);

}  // namespace ripstop
