#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "ripstop/model/tile/tile.h"

namespace ripstop {

/// What a project says about the tiles of one name. Points in the input file's unit, as drawn.
struct ProjectTile {
    std::string name;  ///< a tile's name, or a pattern with * and ? (`glob_match`)
    std::optional<std::string>
        source;                  ///< the surface of the file that is called `name` from now on, by its name there
    std::optional<Vec3> at;      ///< the same by a point on it
    std::optional<Vec3> warp;    ///< any length but zero: the direction given, or from one point to another
    std::optional<double> turn;  ///< instead: the longest axis turned by this [rad]
    std::vector<Vec3> corners;   ///< if any: the tile's corners
    std::optional<Compensation> compensation;  ///< how much longer than drawn the cloth is to be cut
    std::optional<std::string> fabric;         ///< a preset or a file

    bool names_a_surface() const { return source || at; }
};

/// An entry of a project's `tiles`. Throws InputError that begins with `place`.
ProjectTile read_project_tile(const nlohmann::json& value, const std::string& place);

/// The entry that decides for a tile among those of which `gives` holds; null if there is none. The entry with exactly
/// the tile's name goes first; among patterns the later goes before the earlier.
const ProjectTile* deciding_entry(const std::vector<ProjectTile>& entries, const std::string& tile_name,
                                  bool (*gives)(const ProjectTile&));

}  // namespace ripstop
