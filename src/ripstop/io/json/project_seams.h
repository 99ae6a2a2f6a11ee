#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "ripstop/model/project/seam_rule.h"

namespace ripstop {

/// The program's seam types, replaced and extended by those of a project (`seam_types`). Throws InputError that
/// begins with `place`.
std::vector<SeamType> read_seam_types(const nlohmann::json& value, const std::string& place);

/// The seam rules of a project (`seams`), with their types looked up in `types`. Throws InputError that begins
/// with `place`.
std::vector<SeamRule> read_seam_rules(const nlohmann::json& value, const std::vector<SeamType>& types,
                                      const std::string& place);

/// For messages: `seam between "A" and "B"`, `free edge of "A"`.
std::string seam_rule_text(const SeamRule& rule);

}  // namespace ripstop
