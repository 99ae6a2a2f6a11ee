#pragma once

#include <string>

#include "ripstop/model/plan/cut_plan.h"

namespace ripstop {

/// The text of tiles.csv: one line per tile, UTF-8, separated by `,`, with decimal points and LF; fields with a
/// comma, quote or line end are quoted (RFC 4180). Columns are keys of report.json, plus `chain_error_max_pct`,
/// the worst chain's error with its sign, and `finding`, the first one. A figure that is not finite is empty.
std::string tiles_csv(const CutPlan& plan);

/// The table for a terminal: aligned columns, one row per tile in the order of the input. With more than
/// `max_rows` tiles, only the first `max_rows` failing ones have a row, and a line says how many are omitted. Ends
/// with `plan_summary`.
std::string tiles_table(const CutPlan& plan, int max_rows = 40);

/// How many tiles can be made, the area, and the worst of each figure with its tile; the number of patterns, if
/// some are cut more than once; then `seams_summary`.
std::string plan_summary(const CutPlan& plan);

}  // namespace ripstop
