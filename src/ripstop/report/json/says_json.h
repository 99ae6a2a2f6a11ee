#pragma once

#include <nlohmann/json_fwd.hpp>

#include "ripstop/model/plan/cut_plan.h"

namespace ripstop {

/// `envelope.says` of report.json: the texts of `page_words`. A sentence of `why` and `redesign` is a list of
/// parts, each a text, {tile: NAME} or {seam: ID}; `codes` explains each code of the findings.
nlohmann::ordered_json says_json(const CutPlan& plan);

}  // namespace ripstop
