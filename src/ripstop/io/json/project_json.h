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

/// What the input file itself cannot say. Whatever is absent is left to the command line and the defaults.
struct Project {
    std::string file;                              ///< where it was read from
    std::optional<std::string> unit;               ///< of the input file, one that `metres_per_unit` knows
    bool size_is_meant = false;                    ///< the unit is not to be doubted, whatever size follows
    std::optional<std::string> fabric;             ///< of the tiles nothing else is said of
    std::map<std::string, std::string> materials;  ///< the fabric of what the file calls a material, or a fabric
    std::vector<std::string> layers;               ///< globs of the layers that are read; all where empty
    std::vector<std::string> accept;               ///< codes of issues that are meant (`acceptable_issues`)
    std::vector<std::string> grain_layers;         ///< layers of grain lines besides GRAIN and WARP
    std::optional<double> area;                    ///< tolerances, as in `Tolerances`
    std::optional<double> length;                  ///< as a ratio
    std::optional<double> strain;
    std::optional<double> shear;           ///< [rad]
    std::optional<double> seam_tolerance;  ///< edges to be sewn together lie within this [m]
    std::vector<ProjectTile> tiles;
    std::vector<SeamType> seam_types = {ripstop::seam_types().begin(),
                                        ripstop::seam_types().end()};  ///< all that are known
    std::vector<SeamRule> seams;
    Flight flight = {};  ///< how it flies
};

/// A project from JSON: docs/project.md explains it, docs/project.schema.json describes it, docs/project.example.json
/// shows every key. Every key may be absent but a tile's `name` and what a seam type or rule needs to say anything.
///
/// `unit`: of the points of `flight`, where the file's is known; else the project's, else metres.
///
/// Throws InputError naming the file and the place in it for an unknown key, a value of another kind, an unknown unit,
/// seam type or code of an issue, a tolerance that is not positive, a warp without direction, a compensation beyond -50
/// to 100 %, an allowance beyond 0 to 1 m, a surface named in two ways or by a pattern, and a name given twice.
Project read_project(std::istream& in, const std::string& name, const std::string& unit = "");

/// What the project says about the shape of one tile, corners in metres. Warp, corners and compensation are looked up
/// each by itself (`deciding_entry`): one entry may give the warp and another the corners.
TileOptions tile_options(const Project& project, const std::string& tile_name, double metres_per_unit);

/// `defaults` with the project's own tolerances in their place; its strain and shear hold for every fabric.
Tolerances tolerances(const Project& project, const Tolerances& defaults);

/// Names and patterns of the project that fit none of these tiles, in the project's order: most likely misspelt.
std::vector<std::string> unused_names(const Project& project, const std::vector<std::string>& tile_names);

}  // namespace ripstop
