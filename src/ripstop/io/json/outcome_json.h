#pragma once

#include <nlohmann/json.hpp>

#include "ripstop/io/json/plan_reader.h"
#include "ripstop/model/plan/cut_plan.h"

/// What became of a plan's tiles, for flat/sewing.json: all of `CutPlan` that meshes, flat positions and seams do
/// not say. Lengths are in metres, angles in radians; numbers read back to the same doubles, also those that are
/// not finite.
namespace ripstop {

/// The outcome of one tile: method, summary, certificate, seam tensions, bounds, accuracy, verdict, and what it is
/// equal to. `reproducible` leaves out the seconds.
nlohmann::ordered_json outcome_json(const FlatTile& tile, bool reproducible);

/// Reads back what `outcome_json` writes. `tiles`: how many tiles the plan has. Throws InputError.
void read_outcome(const PlanReader& from, std::size_t tiles, FlatTile& into);

/// The outcome of the envelope: input, remarks, findings between tiles, proposed merges, rounds of correction.
nlohmann::ordered_json plan_outcome_json(const CutPlan& plan);

/// Reads back what `plan_outcome_json` writes; the plan has its tiles and seams already. Throws InputError.
void read_plan_outcome(const PlanReader& from, CutPlan& into);

}  // namespace ripstop
