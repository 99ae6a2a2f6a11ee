#pragma once

#include "ripstop/design/natural/gores.h"
#include "ripstop/inflate/equilibrium.h"
#include "ripstop/inflate/sew.h"
#include "ripstop/model/plan/cut_plan.h"
#include "ripstop/model/tile/envelope.h"

/// Designed envelopes of nylon, cut and sewn, and the forces of their design.
namespace ripstop::testing {

/// The tiles and seams of a design, with the warp up the gores.
Envelope balloon(const EnvelopeDesign& design);

/// The flattened balloon, with load tapes up the gores if asked for.
CutPlan cut_balloon(const EnvelopeDesign& design, bool with_tapes);

/// The design's force in a tape at the middle of each panel, from the mouth up [N].
std::vector<double> tape_forces_by_design(const EnvelopeDesign& design);

/// A balloon with load tapes that are cut to carry their design force at their drawn length, and with cloth longer
/// than the tapes by `fullness`.
CutPlan cut_full_balloon(const EnvelopeDesign& design, double fullness, double tape_stiffness);

/// The pressure in flight.
GasPressure hot_air(const SewnEnvelope& sewn);

/// The equilibrium in hot air, with a tolerance far below the compared differences.
Equilibrium rest(const SewnEnvelope& sewn, const Points3& start, double residual = 1e-4);

/// The places of all vertices of all tiles, one after the other [m].
Points3 all_vertices(const SewnEnvelope& sewn, const Points3& nodes);

}  // namespace ripstop::testing
