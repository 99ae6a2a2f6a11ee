#pragma once

#include <filesystem>

#include "ripstop/model/plan/cut_plan.h"

namespace ripstop {

/// Returns the plan in a folder that `write_directory` wrote: meshes and flat positions from flat/NAME.obj, all else
/// from flat/sewing.json. Seams are walked anew. `report_json` of it is report.json byte for byte, unless the plan was
/// inflated: the state in flight is not kept. Throws InputError where the folder is no cut plan, a tile of the plan has
/// no flat positions, or its files do not belong together.
CutPlan read_cut_plan(const std::filesystem::path& folder);

}  // namespace ripstop
