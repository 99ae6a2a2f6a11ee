#include "ripstop/model/project/project.h"

#include <algorithm>

#include "ripstop/base/text/glob.h"

namespace ripstop {

Tolerances tolerances(const Project& project, const Tolerances& defaults) {
    return {project.area.value_or(defaults.area),
            project.length.value_or(defaults.length),
            project.strain.value_or(defaults.strain),
            project.shear.value_or(defaults.shear),
            project.strain.has_value(),
            project.shear.has_value()};
}

std::vector<std::string> unused_names(const Project& project, const std::vector<std::string>& tile_names) {
    std::vector<std::string> unused;
    for (const ProjectTile& entry : project.tiles)
        if (std::none_of(tile_names.begin(), tile_names.end(), [&entry](const std::string& tile) {
                return entry.name == tile || glob_match(entry.name, tile);
            }))
            unused.push_back(entry.name);
    return unused;
}

}  // namespace ripstop
