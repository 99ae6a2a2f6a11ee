#pragma once

#include <iosfwd>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ripstop/io/json/project_seams.h"
#include "ripstop/io/json/project_tiles.h"
#include "ripstop/model/flight/flight.h"
#include "ripstop/model/plan/verdict.h"
#include "ripstop/model/tile/tile.h"

namespace ripstop {

/// What the user says about an input file beyond its contents. The command line and the defaults fill in what is
/// absent.
struct Project {
    std::string file;                              ///< the file that the project was read from
    std::optional<std::string> unit;               ///< of the input file, a name that `metres_per_unit` knows
    bool size_is_meant = false;                    ///< accept the unit without a warning, whatever size results
    std::optional<std::string> fabric;             ///< of the tiles for which nothing else is given
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
    Flight flight = {};  ///< how it flies
};

/// Reads a project from JSON: docs/project.md explains it, docs/project.schema.json describes it,
/// docs/project.example.json shows every key. All keys are optional except a tile's `name` and what makes a seam
/// type or rule meaningful.
///
/// `unit` is the unit of the points of `flight`, if the file's unit is known; else the project's unit, else
/// metres.
///
/// Throws InputError with the file and the place in it for an unknown key, a value of the wrong type, an unknown
/// unit, seam type or issue code, a tolerance that is not positive, a warp without direction, a compensation
/// outside -50 to 100 %, an allowance outside 0 to 1 m, a surface that is named twice or by a pattern, and a
/// duplicate name.
Project read_project(std::istream& in, const std::string& name, const std::string& unit = "");

/// The options for the shape of one tile, with corners in metres. Warp, corners and compensation are looked up
/// separately (`deciding_entry`): one entry may give the warp and another the corners.
TileOptions tile_options(const Project& project, const std::string& tile_name, double metres_per_unit);

/// `defaults`, overridden by the project's own tolerances. Its strain and shear limits apply to every fabric.
Tolerances tolerances(const Project& project, const Tolerances& defaults);

/// Names and patterns of the project that match none of these tiles, in the project's order. They are probably
/// misspelt.
std::vector<std::string> unused_names(const Project& project, const std::vector<std::string>& tile_names);

}  // namespace ripstop
