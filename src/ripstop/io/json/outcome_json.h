#pragma once

#include <nlohmann/json.hpp>

#include "ripstop/io/json/plan_reader.h"
#include "ripstop/model/plan/cut_plan.h"

/// The outcome of a plan's tiles, for flat/sewing.json: everything in `CutPlan` besides meshes, flat positions and
/// seams. Lengths are in metres, angles in radians. Numbers read back as the same doubles, even if they are not
/// finite.
namespace ripstop {

/// The outcome of one tile: method, summary, certificate, seam tensions, bounds, accuracy, verdict, and its equal
/// tile. `reproducible` omits the seconds.
nlohmann::ordered_json outcome_json(const FlatTile& tile, bool reproducible);

/// Reads what `outcome_json` wrote. `tiles` is the number of tiles of the plan. Throws InputError.
void read_outcome(const PlanReader& from, std::size_t tiles, FlatTile& into);

/// The outcome of the envelope: input, remarks, findings between tiles, proposed merges, rounds of correction.
nlohmann::ordered_json plan_outcome_json(const CutPlan& plan);

/// Reads what `plan_outcome_json` wrote. The plan must have its tiles and seams. Throws InputError.
void read_plan_outcome(const PlanReader& from, CutPlan& into);

}  // namespace ripstop
