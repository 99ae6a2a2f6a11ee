#pragma once

#include <string>
#include <vector>

#include "ripstop/model/plan/cut_plan.h"

namespace ripstop {

/// Version of the keys of report.json. The first number changes if a key is removed or changes its meaning.
inline constexpr const char* report_schema = "1.3";

/// The text of report.json, as docs/report.schema.json describes it. Every key carries its unit. Figures have 12
/// significant digits; one that is not finite (the energy of a flipped tile, the errors of a failed one) is null.
/// `reproducible` omits `seconds`, the only value that differs between runs. `file` of each tile is the stem of
/// its files.
std::string report_json(const CutPlan& plan, bool reproducible = false);

}  // namespace ripstop
