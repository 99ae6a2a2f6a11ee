#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <sstream>

#include "require.h"
#include "ripstop/base/error.h"
#include "ripstop/io/json/project_json.h"
#include "ripstop/model/plan/envelope_check.h"
#include "ripstop/pipeline/read/tile_options.h"
#include "ripstop/tile/make_tile.h"

using namespace ripstop;
using fuzzing::require;

namespace {

bool is_sound(const SeamType& type) {
    return !type.name.empty() && type.allowance >= 0 && type.allowance <= 1 + 1e-9 && type.rows >= 0;
}

}  // namespace

/// Any bytes give a project or an InputError. A project gives every tile finite options and a warp of unit length
/// or a turn, and every seam a type with an allowance.
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
        require(!tile.warp || (options.warp && std::abs(options.warp->norm() - 1) < 1e-9));
        require(!tile.turn || (std::abs(*tile.turn) < 7 && !tile.warp));
        require(!tile.at || (tile.at->allFinite() && !tile.source));
        for (const Vec3& corner : options.corners) require(corner.allFinite());
    }
    for (const std::string& code : project.accept)
        require(std::find(acceptable_issues.begin(), acceptable_issues.end(), code) != acceptable_issues.end());
    require(unused_names(project, {"G01P01"}).empty() || !project.tiles.empty());
    for (const SeamType& type : project.seam_types) require(is_sound(type));
    for (const SeamRule& rule : project.seams) {
        require(is_sound(rule.type) && !rule.tile.empty());
        require(rule.mate ? rule.fits_seam(rule.tile, *rule.mate) && rule.fits_seam(*rule.mate, rule.tile)
                          : rule.fits_free(rule.tile));
    }
    return 0;
}
