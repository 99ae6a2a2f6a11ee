#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ripstop/model/flight/flight.h"
#include "ripstop/model/plan/verdict.h"
#include "ripstop/model/project/project_tile.h"
#include "ripstop/model/project/seam_rule.h"

namespace ripstop {

/// What the user says about an input file beyond its contents. The command line and the defaults fill in what is
/// absent.
struct Project {
    std::string file;                              ///< the file that the project was read from
    std::optional<std::string> unit;               ///< unit of the input file, a name that `metres_per_unit` knows
    bool size_is_meant = false;                    ///< accept the unit without a warning, whatever the resulting size
    std::optional<std::string> fabric;             ///< default fabric of the tiles
    std::map<std::string, std::string> materials;  ///< the fabric (value) of a material or fabric that the input
                                                   ///< file names (key)
    std::vector<std::string> layers;               ///< globs of the layers to read; empty: all
    std::vector<std::string> accept;               ///< codes of issues that are intended (`acceptable_issues`)
    std::vector<std::string> grain_layers;         ///< layers of grain lines, in addition to GRAIN and WARP
    std::optional<double> area;                    ///< tolerances, as in `Tolerances`
    std::optional<double> length;                  ///< as a ratio
    std::optional<double> strain;
    std::optional<double> shear;           ///< [rad]
    std::optional<double> seam_tolerance;  ///< edges to be sewn together lie within this distance [m]
    std::vector<ProjectTile> tiles;
    std::vector<SeamType> seam_types = {ripstop::seam_types().begin(),
                                        ripstop::seam_types().end()};  ///< all known types
    std::vector<SeamRule> seams;
    Flight flight = {};  ///< flight conditions
};

/// `defaults`, overridden by the project's own tolerances. Its strain and shear limits apply to every fabric.
Tolerances tolerances(const Project& project, const Tolerances& defaults);

/// Names and patterns of the project that match none of these tiles, in the project's order. They are probably
/// misspelt.
std::vector<std::string> unused_names(const Project& project, const std::vector<std::string>& tile_names);

}  // namespace ripstop
