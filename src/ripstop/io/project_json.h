#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "ripstop/model/tile.h"
#include "ripstop/model/verdict.h"

namespace ripstop {

/// What a project says about the tiles of one name. Points in the input file's unit, as drawn.
struct ProjectTile {
    std::string name;           ///< a tile's name, or a pattern with * and ? (`glob_match`)
    std::optional<Vec3> warp;   ///< any length but zero: the direction given, or from one point to another
    std::vector<Vec3> corners;  ///< if any: the tile's corners
    std::optional<Compensation> compensation;  ///< how much longer than drawn the cloth is to be cut
};

/// What the input file itself cannot say. Whatever is absent is left to the command line and the defaults.
struct Project {
    std::string file;                 ///< where it was read from
    std::optional<std::string> unit;  ///< of the input file, one that `metres_per_unit` knows
    std::optional<std::string> fabric;
    std::optional<double> area;    ///< tolerances, as in `Tolerances`
    std::optional<double> length;  ///< as a ratio
    std::optional<double> strain;
    std::optional<double> shear;           ///< [rad]
    std::optional<double> seam_tolerance;  ///< edges to be sewn together lie within this [m]
    std::vector<ProjectTile> tiles;
};

/// A project from JSON; docs/project.schema.json describes it, docs/project.example.json shows it.
///
///     {"unit": "mm", "fabric": "nylon", "tolerances": {"area_pct": 1, "length_pct": 0.1, "strain_pct": 2, "shear_deg": 10},
///      "tiles": [{"name": "G*", "warp": {"direction": [0, 0, 1]}},
///                {"name": "G01P03", "warp": {"from": [0, 0, 0], "to": [0, 100, 900]}, "corners": [[0, 0, 0], [250, 0, 0]],
///                 "compensation": {"warp_pct": 0.6, "weft_pct": 0.3, "chains_pct": [0, 0, 0.2, 0]}}]}
///
/// Every key may be absent but a tile's `name`. Throws InputError naming the file and the place in it for an unknown key, a
/// value of another kind, an unknown unit, a tolerance that is not positive, a warp without direction, a compensation beyond -50 to 100 % and a name given twice.
Project read_project(std::istream& in, const std::string& name);

/// What the project says about one tile, corners in metres. The entry with exactly the tile's name goes first; among patterns
/// the later goes before the earlier, so general ones stand above special ones. Warp, corners and compensation are looked up each
/// by itself: one entry may give the warp and another the corners.
TileOptions tile_options(const Project& project, const std::string& tile_name, double metres_per_unit);

/// `defaults` with the project's own tolerances in their place.
Tolerances tolerances(const Project& project, const Tolerances& defaults);

/// Names and patterns of the project that fit none of these tiles, in the project's order: most likely misspelt.
std::vector<std::string> unused_names(const Project& project, const std::vector<std::string>& tile_names);

}  // namespace ripstop
