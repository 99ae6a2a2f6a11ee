#pragma once

#include <nlohmann/json_fwd.hpp>

#include "ripstop/model/plan/cut_plan.h"

namespace ripstop {

/// `envelope.says` of report.json: the words of `page_words`. A sentence of `why` and `redesign` is a list of parts,
/// each a text, {tile: NAME} or {seam: ID}; `codes` tells what each code of the findings means.
nlohmann::ordered_json says_json(const CutPlan& plan);

}  // namespace ripstop
