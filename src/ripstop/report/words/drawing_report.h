#pragma once

#include <string>

#include "ripstop/model/piece/drawing_check.h"

namespace ripstop {

/// What was found of a pattern file, for a terminal: what it is, then each issue on a line of its own.
std::string drawing_text(const DrawingCheck& check, const std::string& file);

/// The same for machines, one JSON object: `docs/validate.schema.json`.
std::string drawing_json(const DrawingCheck& check, const std::string& file);

}  // namespace ripstop
