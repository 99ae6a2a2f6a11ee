#pragma once

#include <nlohmann/json.hpp>

#include "ripstop/model/plan/cut_plan.h"

namespace ripstop {

/// `inflated` of report.json: all that `Inflated` holds but its fields of numbers, and what it says (`inflated_says`).
/// Strains are of threads, |F e| - 1 of the cloth as cut; stresses second Piola-Kirchhoff. `reproducible` leaves out
/// `seconds`. Requires `plan.inflated`.
nlohmann::ordered_json inflated_json(const CutPlan& plan, bool reproducible);

/// `tiles[].inflated`: how far the tile is off, what its cloth bears.
nlohmann::ordered_json inflated_tile_json(const InflatedTile& tile);

}  // namespace ripstop
