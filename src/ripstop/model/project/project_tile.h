#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ripstop/model/tile/tile.h"

namespace ripstop {

/// A project's entry for the tiles of one name or pattern. Points are in the input file's unit, as drawn.
struct ProjectTile {
    std::string name;                   ///< a tile's name, or a pattern with * and ? (`glob_match`)
    std::optional<std::string> source;  ///< the surface of the file, by its name there, that is renamed to `name`
    std::optional<Vec3> at;             ///< the same surface, by a point on it
    std::optional<Vec3> warp;           ///< of any length but zero: a direction, or the vector between two points
    std::optional<double> turn;         ///< instead of `warp`: the longest axis rotated by this angle [rad]
    std::vector<Vec3> corners;          ///< the tile's corners; empty: found automatically
    std::optional<Compensation> compensation;  ///< how much longer than drawn the cloth is cut
    std::optional<std::string> fabric;         ///< a preset or a file

    bool names_a_surface() const { return source || at; }
};

/// The entry that decides for a tile, among those for which `gives` is true; null if there is none. An entry with
/// exactly the tile's name wins; otherwise the last matching pattern does.
const ProjectTile* deciding_entry(const std::vector<ProjectTile>& entries, const std::string& tile_name,
                                  bool (*gives)(const ProjectTile&));

}  // namespace ripstop
