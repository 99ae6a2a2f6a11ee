#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "ripstop/model/project/project_tile.h"

namespace ripstop {

/// Reads an entry of a project's `tiles`. Throws InputError that begins with `place`.
ProjectTile read_project_tile(const nlohmann::json& value, const std::string& place);

}  // namespace ripstop
