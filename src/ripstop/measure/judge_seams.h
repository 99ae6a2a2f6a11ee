#pragma once

#include <string>

#include "ripstop/model/plan/cut_plan.h"

namespace ripstop {

/// Judges what lies between the tiles of a plan whose tiles are judged and whose seams are walked.
///
/// A seam that is not `ok` is a finding of the plan, `seam`: its worst drift and limit in mm, and where. One whose
/// length the meshes leave open by more than it may err is one too, `uncertain`, though its sides agree: that open
/// length and the limit in mm.
///
/// The paper's waiver: an edge may miss its drawn length if its mate does so too. A tile's finding `chain` is moved to
/// `waived` where seams cover the whole chain and all of them are ok; with it goes `perimeter`, once no chain is left
/// that fails.
void judge_seams(CutPlan& plan);

/// What is said of a seam whose length the meshes of its tiles leave open by more than `limit` [m].
std::string uncertain_text(const Seam& seam, const std::string& tile_a, const std::string& tile_b, double limit);

}  // namespace ripstop
