#pragma once

#include <string>
#include <vector>

#include "ripstop/model/plan/cut_plan.h"

/// The same tiles flattened by several methods, side by side. `plans`: one a method, at least one, each with the same
/// tiles in the same order. A row or shape for each tile and method, tile by tile, in the order of the plans.
namespace ripstop {

/// For a terminal: columns aligned.
std::string comparison_table(const std::vector<CutPlan>& plans);

/// JSON: `tiles[]` with `name` and `methods[]`, each of which is what report.json says of that tile
/// (docs/report.schema.json).
std::string comparison_json(const std::vector<CutPlan>& plans);

/// An SVG sheet of all the flat shapes, each with the colour maps of its cloth and chains, at one scale a tile; the
/// warp to the right. A method that gave nothing has its reason instead. About 50 bytes a triangle and method.
std::string comparison_sheet(const std::vector<CutPlan>& plans);

}  // namespace ripstop
