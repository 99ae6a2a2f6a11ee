#pragma once

#include <vector>

#include "ripstop/model/tile/cad_model.h"

namespace ripstop {

/// What designed tiles came out as.
struct TilesSummary {
    int tiles = 0;
    int triangles = 0;
    int euler = 0;        ///< of the tiles welded: 2 closed, one less for each opening, two less for each handle
    int openings = 0;     ///< boundary loops of the welded whole
    double rim = 0;       ///< length of these loops [m]
    double area = 0;      ///< of the triangles [m2]
    double volume = 0;    ///< within the triangles and a flat cap on each opening [m3]
    double height = 0;    ///< lowest to highest vertex [m]
    double edge_min = 0;  ///< shortest and longest edge of any triangle [m]
    double edge_max = 0;
    double angle_min = 0;    ///< smallest angle of any triangle [rad]
    double turn_max = 0;     ///< largest angle between triangles that share an edge within a tile [rad]
    double chord_error = 0;  ///< largest distance of chord and arc across such an edge: turn height / 8 [m]
    double tile_width = 0;   ///< greatest extent of a tile across its longest axis [m]
    double tile_length = 0;  ///< greatest extent of a tile along it [m]
};

/// Measures tiles that share positions on their seams bit for bit. O(#F log #F).
TilesSummary measure_tiles(const std::vector<NamedMesh>& tiles);

/// One mesh of all tiles, vertices at the same place (bit for bit) made one.
TriangleMesh welded(const std::vector<NamedMesh>& tiles);

}  // namespace ripstop
