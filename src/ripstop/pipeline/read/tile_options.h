#pragma once

#include <string>

#include "ripstop/model/project/project.h"
#include "ripstop/tile/make_tile.h"

namespace ripstop {

/// The options for the shape of one tile, with corners in metres. Warp, corners and compensation are looked up
/// separately (`deciding_entry`): one entry may give the warp and another the corners.
TileOptions tile_options(const Project& project, const std::string& tile_name, double metres_per_unit);

}  // namespace ripstop
