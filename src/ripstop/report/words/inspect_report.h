#pragma once

#include <string>

#include "ripstop/model/tile/cad_model.h"

namespace ripstop {

/// What a file holds before any tile is made of it, for a terminal: unit, layers, surfaces and curves with their sizes
/// in the file's own unit, what could not be read and why, remarks. Of long lists the first 20 and how many more there
/// are.
std::string inspect_text(const CadModel& model, const std::string& file);

/// The same in full for machines, one JSON object: `docs/inspect.schema.json`.
std::string inspect_json(const CadModel& model, const std::string& file);

}  // namespace ripstop
