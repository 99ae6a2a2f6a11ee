#pragma once

#include "ripstop/design/natural/gores.h"
#include "ripstop/inflate/equilibrium.h"
#include "ripstop/inflate/sew.h"
#include "ripstop/model/plan/cut_plan.h"
#include "ripstop/model/tile/envelope.h"

/// Designed envelopes of nylon, cut and sewn, and the forces of their design.
namespace ripstop::testing {

/// The design's tiles and seams, warp up the gores.
Envelope balloon(const EnvelopeDesign& design);

/// Flattened; load tapes up the gores where asked.
CutPlan cut_balloon(const EnvelopeDesign& design, bool with_tapes);

/// The force in a tape of the design in the middle of each panel, from the mouth up [N].
std::vector<double> tape_forces_by_design(const EnvelopeDesign& design);

/// With load tapes, cut so that they bear their force by design at their drawn length, and cloth longer than they
/// are by `fullness`.
CutPlan cut_full_balloon(const EnvelopeDesign& design, double fullness, double tape_stiffness);

/// The pressure in flight.
GasPressure hot_air(const SewnEnvelope& sewn);

/// At rest in hot air, to a tolerance far below what is compared.
Equilibrium rest(const SewnEnvelope& sewn, const Points3& start, double residual = 1e-4);

/// Where each vertex of each tile is, one after the other [m].
Points3 all_vertices(const SewnEnvelope& sewn, const Points3& nodes);

}  // namespace ripstop::testing
