#pragma once

#include <nlohmann/json.hpp>

#include "ripstop/model/plan/cut_plan.h"

namespace ripstop {

/// `inflated` of report.json: everything in `Inflated` except its arrays, and the sentences of `inflated_says`.
/// Strains are those of threads, |F e| - 1 of the cloth as cut; stresses are second Piola-Kirchhoff.
/// `reproducible` omits `seconds`. Requires `plan.inflated`.
nlohmann::ordered_json inflated_json(const CutPlan& plan, bool reproducible);

/// `tiles[].inflated`: the tile's deviation, and the load on its cloth.
nlohmann::ordered_json inflated_tile_json(const InflatedTile& tile);

}  // namespace ripstop
