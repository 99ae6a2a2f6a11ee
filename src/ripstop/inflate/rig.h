#pragma once

#include <functional>

#include "ripstop/model/flight/rigging.h"
#include "ripstop/model/flight/sewn_envelope.h"
#include "ripstop/model/plan/cut_plan.h"
#include "ripstop/model/plan/seam_place.h"
#include "ripstop/model/plan/symmetry.h"

namespace ripstop {

/// Where a place of a tile's boundary is in the sewn envelope.
using PlaceOnBoundary = std::function<Place(int tile, const BoundaryPlace&)>;

/// Adds to the sewn cloth what `sew` says: load tapes along the seams that take one, what holds the mouth, the crown
/// ring and the valve that closes it. Throws InputError where nothing could hold the envelope.
void add_rigging(const CutPlan& plan, const Rigging& rigging, const Symmetry& symmetry,
                 const std::vector<char>& is_inside, const std::vector<double>& tape_factors,
                 const PlaceOnBoundary& place_of, SewnEnvelope& sewn);

}  // namespace ripstop
