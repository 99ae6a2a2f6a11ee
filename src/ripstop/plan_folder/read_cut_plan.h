#pragma once

#include <filesystem>

#include "ripstop/model/plan/cut_plan.h"

namespace ripstop {

/// The plan in a folder that `write_directory` wrote, to be sewn: meshes and flat positions from flat/NAME.obj, the
/// rest from flat/sewing.json, seams walked and everything judged anew. How the flattenings came about is not in it.
/// Throws InputError where the folder is no cut plan, or its files do not belong together.
CutPlan read_cut_plan(const std::filesystem::path& folder);

}  // namespace ripstop
