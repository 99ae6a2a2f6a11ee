#pragma once

#include <string>

#include "ripstop/model/plan/envelope_check.h"

namespace ripstop {

/// The picture of an envelope for a terminal: what was understood, then each issue on a line of its own.
std::string check_text(const EnvelopeCheck& check, const std::string& file, const std::string& unit);

/// The same for machines, one JSON object: `docs/check.schema.json`.
std::string check_json(const EnvelopeCheck& check, const std::string& file, const std::string& unit);

}  // namespace ripstop
