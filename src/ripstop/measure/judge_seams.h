#pragma once

#include "ripstop/model/cut_plan.h"

namespace ripstop {

/// Judges what lies between the tiles of a plan whose tiles are judged and whose seams are walked.
///
/// A seam that is not `ok` is a finding of the plan, `seam`: its worst drift and limit in mm, and where.
///
/// The paper's waiver: an edge may miss its drawn length if its mate does so too. A tile's finding `chain` is moved to
/// `waived` where seams cover the whole chain and all of them are ok; with it goes `perimeter`, once no chain is left that
/// fails.
void judge_seams(CutPlan& plan);

}  // namespace ripstop
