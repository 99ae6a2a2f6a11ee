#pragma once

#include <functional>

#include "ripstop/model/flight/rigging.h"
#include "ripstop/model/flight/sewn_envelope.h"
#include "ripstop/model/plan/cut_plan.h"
#include "ripstop/model/plan/symmetry.h"
#include "ripstop/tile/seam_place.h"

namespace ripstop {

/// The place in the sewn envelope of a place on a tile's boundary.
using PlaceOnBoundary = std::function<SewnPoint(int tile, const BoundaryPlace&)>;

/// Adds the rigging to the sewn cloth as described at `sew`: load tapes along the seams that have one, the supports
/// of the mouth, the crown ring and the valve that closes it. Throws InputError if nothing could hold the envelope.
void add_rigging(const CutPlan& plan, const Rigging& rigging, const Symmetry& symmetry,
                 const std::vector<char>& is_inside, const std::vector<double>& tape_factors,
                 const PlaceOnBoundary& place_of, SewnEnvelope& sewn);

}  // namespace ripstop
