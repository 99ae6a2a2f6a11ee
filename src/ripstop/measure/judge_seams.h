#pragma once

#include <string>

#include "ripstop/model/plan/cut_plan.h"

namespace ripstop {

/// Judges the seams of a plan. Requires that its tiles are judged and its seams are walked.
///
/// A seam that is not `ok` becomes the finding `seam` of the plan, with its largest drift and limit in mm and the
/// place. If the meshes leave its length uncertain by more than the limit, it becomes the finding `uncertain` even if
/// its sides agree, with that uncertainty and the limit in mm.
///
/// The paper's waiver: an edge may miss its drawn length if its mate misses it equally. A tile's finding `chain`
/// moves to `waived` if seams cover the whole chain and all of them are ok. The finding `perimeter` moves too once no
/// failing chain is left.
void judge_seams(CutPlan& plan);

/// The message on a seam whose length is uncertain by more than `limit` [m] because of the meshes of its tiles.
std::string uncertain_text(const Seam& seam, const std::string& tile_a, const std::string& tile_b, double limit);

}  // namespace ripstop
