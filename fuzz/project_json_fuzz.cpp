#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <sstream>

#include "ripstop/base/error.h"
#include "ripstop/io/project_json.h"

using namespace ripstop;

/// Any bytes are either a project that gives every tile finite options and a warp of unit length, or an InputError.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::istringstream in(std::string(reinterpret_cast<const char*>(data), size));
    Project project;
    try {
        project = read_project(in, "fuzz.json");
    } catch (const InputError&) {
        return 0;
    }
    for (const ProjectTile& tile : project.tiles) {
        const TileOptions options = tile_options(project, tile.name, 1);
        if (tile.warp && (!options.warp || !(std::abs(options.warp->norm() - 1) < 1e-9))) std::abort();
        for (const Vec3& corner : options.corners)
            if (!corner.allFinite()) std::abort();
    }
    if (!unused_names(project, {"G01P01"}).empty() && project.tiles.empty()) std::abort();
    return 0;
}
