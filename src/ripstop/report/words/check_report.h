#pragma once

#include <string>

#include "ripstop/model/plan/envelope_check.h"

namespace ripstop {

/// The report on an envelope for a terminal: what was understood, then one line per issue.
std::string check_text(const EnvelopeCheck& check, const std::string& file, const std::string& unit);

/// The same report as one JSON object: `docs/check.schema.json`.
std::string check_json(const EnvelopeCheck& check, const std::string& file, const std::string& unit);

}  // namespace ripstop
