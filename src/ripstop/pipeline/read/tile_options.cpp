#include "ripstop/pipeline/read/tile_options.h"

#include <filesystem>

#include "ripstop/io/text/text.h"

namespace ripstop {

TileOptions tile_options(const Project& project, const std::string& tile_name, double metres_per_unit) {
    TileOptions options;
    if (const ProjectTile* entry = deciding_entry(project.tiles, tile_name, [](const ProjectTile& tile) {
            return tile.warp.has_value() || tile.turn.has_value();
        })) {
        options.warp = entry->warp;
        options.grain_turn = entry->turn;
        options.warp_source = std::filesystem::path(project.file).filename().string() + ", tile " + shown(entry->name);
    }
    if (const ProjectTile* entry =
            deciding_entry(project.tiles, tile_name, [](const ProjectTile& tile) { return !tile.corners.empty(); }))
        for (const Vec3& corner : entry->corners) options.corners.push_back(corner * metres_per_unit);
    if (const ProjectTile* entry = deciding_entry(
            project.tiles, tile_name, [](const ProjectTile& tile) { return tile.compensation.has_value(); }))
        options.compensation = *entry->compensation;
    return options;
}

}  // namespace ripstop
