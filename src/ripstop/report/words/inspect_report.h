#pragma once

#include <string>

#include "ripstop/model/tile/cad_model.h"

namespace ripstop {

/// The contents of a file before tiles are made, for a terminal: unit, layers, surfaces and curves with their
/// sizes in the file's own unit, what could not be read and why, remarks. Long lists show the first 20 and the
/// number of others.
std::string inspect_text(const CadModel& model, const std::string& file);

/// The same in full as one JSON object: `docs/inspect.schema.json`.
std::string inspect_json(const CadModel& model, const std::string& file);

}  // namespace ripstop
