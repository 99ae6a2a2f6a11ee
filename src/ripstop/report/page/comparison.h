#pragma once

#include <string>
#include <vector>

#include "ripstop/model/plan/cut_plan.h"

/// The same tiles flattened by several methods. `plans`: one per method, at least one, with the same tiles in the same
/// order. The output has one row or shape for each tile and method: tile by tile, in the order of the plans.
namespace ripstop {

/// A table for a terminal, with aligned columns.
std::string comparison_table(const std::vector<CutPlan>& plans);

/// JSON: `tiles[]` with `name` and `methods[]`; each entry has the fields of that tile in report.json
/// (docs/report.schema.json).
std::string comparison_json(const std::vector<CutPlan>& plans);

/// An SVG sheet with all flat shapes, coloured by the maps of cloth and chains. Each tile has one scale; the warp
/// points right. A method without a result shows its reason instead. About 50 bytes per triangle and method.
std::string comparison_sheet(const std::vector<CutPlan>& plans);

}  // namespace ripstop
