#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ripstop/base/text/units.h"
#include "ripstop/model/tile/tile.h"

namespace ripstop {

/// Options of `make_tile` for corners and warp.
struct TileOptions {
    double corner_angle = 30 * degree;  ///< a boundary vertex with a larger turn is a corner [rad]
    std::vector<Vec3> corners = {};     ///< if any: replace the automatic corners by the boundary vertices nearest to
                                        ///< these points
    std::optional<Vec3> warp = {};      ///< default: the longest axis
    Points3 warp_field = {};            ///< #F x 3: a direction per triangle; used if no `warp` is given; may be empty
    std::string warp_source = "given";  ///< origin of the warp, in words
    std::optional<double> grain_turn = {};  ///< rotates the longest axis, counter-clockwise seen from outside [rad]
    std::optional<Points2> drawn = {};
    Compensation compensation = {};
    Attributes attributes = {};
};

/// Makes a tile of a mesh. Corners are where the boundary turns by more than `corner_angle` within the surface: pi
/// minus the sum of the triangle angles at the vertex, so a gentle curve in space is not a corner. Throws InputError
/// (`require_disk`, or a warp normal to the surface).
Tile make_tile(std::string name, TriangleMesh mesh, const TileOptions& options = {});

/// The longest direction of a tile: the axis of largest second moment of its area, oriented towards +z (else +y, else
/// +x). If it is not unique, as round a tube, that of the unrolled tile (`longest_axis_on_cloth`).
Vec3 longest_axis(const TriangleMesh& mesh);

}  // namespace ripstop
