#pragma once

#include <string>
#include <vector>

#include "ripstop/model/plan/cut_plan.h"

namespace ripstop {

/// Version of the keys of report.json: the first number changes when a key goes or changes its meaning.
inline constexpr const char* report_schema = "1.3";

/// The text of report.json: what docs/report.schema.json describes. Every key carries its unit; figures have 12
/// significant digits; a figure that is not finite (the energy of a flipped tile, the errors of a failed one) is null.
/// `reproducible` leaves out `seconds`, the only thing that differs from run to run. Each tile's `file` is the stem of
/// its files. `warnings`: what may be meant and is no finding, a sentence each.
std::string report_json(const CutPlan& plan, bool reproducible = false, const std::vector<std::string>& warnings = {});

}  // namespace ripstop
