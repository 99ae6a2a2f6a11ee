#pragma once

#include <string>

#include "ripstop/model/piece/drawing_check.h"

namespace ripstop {

/// The report on a pattern file for a terminal: what it is, then one line per issue.
std::string drawing_text(const DrawingCheck& check, const std::string& file);

/// The same report as one JSON object: `docs/validate.schema.json`.
std::string drawing_json(const DrawingCheck& check, const std::string& file);

}  // namespace ripstop
