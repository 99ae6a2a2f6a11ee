#pragma once

#include <filesystem>

#include "ripstop/model/plan/cut_plan.h"

namespace ripstop {

/// Reads the plan from a folder written by `write_directory`: meshes and flat positions from flat/NAME.obj, everything
/// else from flat/sewing.json. Seams are walked again. `report_json` of the result equals report.json byte for byte,
/// unless the plan was inflated: the state in flight is not restored. Throws InputError if it is not a cut plan folder,
/// if a tile has no flat positions, or if its files do not belong together.
CutPlan read_cut_plan(const std::filesystem::path& folder);

}  // namespace ripstop
