#pragma once

#include <string>

#include "ripstop/model/plan/cut_plan.h"

namespace ripstop {

/// tiles.csv: a line a tile, UTF-8, `,` between, `.` decimals, LF; fields with a comma, quote or line end in quotes
/// (RFC 4180). Columns are keys of report.json, plus `chain_error_max_pct`, the worst chain's with its sign, and
/// `finding`, the first. A figure that is not finite is left empty.
std::string tiles_csv(const CutPlan& plan);

/// The table for a terminal: columns aligned, a row a tile in the order of the input. Above `max_rows` tiles only the
/// first `max_rows` failing ones have a row, and a line says how many are not shown. Ends with `plan_summary`.
std::string tiles_table(const CutPlan& plan, int max_rows = 40);

/// How many tiles can be made, the area, and the worst of each figure with the tile that has it; how many patterns that
/// takes, where some are cut more than once; then `seams_summary`.
std::string plan_summary(const CutPlan& plan);

}  // namespace ripstop
