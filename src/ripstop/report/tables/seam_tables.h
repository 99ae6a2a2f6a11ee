#pragma once

#include <string>
#include <vector>

#include "ripstop/model/plan/cut_plan.h"

namespace ripstop {

/// The text of seams.csv: one line per seam, in the form of tiles.csv. Columns are keys of report.json. Only the
/// header if the plan has no seams.
std::string seams_csv(const CutPlan& plan);

/// How many seams agree, the worst mismatch and drift with their seams, and how many seams the meshes leave
/// uncertain; omitted for a plan without seams. Then a line for each of the plan's first `max_rows` findings.
std::string seams_summary(const CutPlan& plan, int max_rows = 8);

/// The seams along each chain of each tile, as indices into `CutPlan::seams`, in order along the chain.
std::vector<std::vector<std::vector<int>>> seams_of_chains(const CutPlan& plan);

}  // namespace ripstop
