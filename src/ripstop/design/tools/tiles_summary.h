#pragma once

#include <vector>

#include "ripstop/model/tile/cad_model.h"

namespace ripstop {

/// The dimensions of designed tiles.
struct TilesSummary {
    int tiles = 0;
    int triangles = 0;
    int euler = 0;        ///< Euler number of the welded tiles: 2 if closed, one less per opening, two less per handle
    int openings = 0;     ///< boundary loops of the welded tiles
    double rim = 0;       ///< length of these loops [m]
    double area = 0;      ///< total area of the triangles [m2]
    double volume = 0;    ///< volume enclosed by the triangles and a flat cap on each opening [m3]
    double height = 0;    ///< from lowest to highest vertex [m]
    double edge_min = 0;  ///< shortest and longest edge of any triangle [m]
    double edge_max = 0;
    double angle_min = 0;    ///< smallest angle of any triangle [rad]
    double turn_max = 0;     ///< largest dihedral turn at an edge within a tile [rad]
    double chord_error = 0;  ///< largest distance between chord and arc across such an edge: turn height / 8 [m]
    double tile_width = 0;   ///< largest extent of a tile across its longest axis [m]
    double tile_length = 0;  ///< largest extent of a tile along it [m]
};

/// Measures tiles whose positions on seams agree bit for bit. O(#F log #F).
TilesSummary measure_tiles(const std::vector<NamedMesh>& tiles);

/// One mesh of all tiles, with vertices at the same place (bit for bit) merged.
TriangleMesh welded(const std::vector<NamedMesh>& tiles);

}  // namespace ripstop
