#include "ripstop/model/project/project_tile.h"

#include "ripstop/base/text/glob.h"

namespace ripstop {

const ProjectTile* deciding_entry(const std::vector<ProjectTile>& entries, const std::string& tile_name,
                                  bool (*gives)(const ProjectTile&)) {
    const ProjectTile* found = nullptr;
    for (const ProjectTile& entry : entries) {
        if (!gives(entry)) continue;
        if (entry.name == tile_name) return &entry;
        if (glob_match(entry.name, tile_name)) found = &entry;
    }
    return found;
}

}  // namespace ripstop
