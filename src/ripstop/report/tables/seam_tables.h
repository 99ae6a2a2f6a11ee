#pragma once

#include <string>
#include <vector>

#include "ripstop/model/plan/cut_plan.h"

namespace ripstop {

/// seams.csv: a line a seam, in the form of tiles.csv. Columns are keys of report.json; only the heads where the plan
/// has no seams.
std::string seams_csv(const CutPlan& plan);

/// How many seams agree and the worst mismatch and drift, with the seams that have them, and how many the meshes leave
/// uncertain; nothing of it for a plan without seams. Below it a line for each of the plan's first `max_rows` findings.
std::string seams_summary(const CutPlan& plan, int max_rows = 8);

/// The seams along each chain of each tile, as indices into `CutPlan::seams` in their order along the chain.
std::vector<std::vector<std::vector<int>>> seams_of_chains(const CutPlan& plan);

}  // namespace ripstop
