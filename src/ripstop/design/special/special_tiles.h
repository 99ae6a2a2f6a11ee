#pragma once

#include <string>
#include <vector>

#include "ripstop/design/special/special_surface.h"
#include "ripstop/model/tile/cad_model.h"

namespace ripstop {

/// A future tile: a connected set of triangles of a cell, with adjacent pieces that are too small for a tile.
struct SpecialTile {
    BodyCell cell;
    int nth = 0;  ///< number among the tiles of that cell
};

/// Numbers the tiles in `surface.tile` (-1: below the mouth). A piece smaller than a twentieth of the median area is
/// merged with the neighbour that has the longest common border, preferably one on its own face. Sorted by primitive,
/// part, sector and ring. O(#F log #F).
std::vector<SpecialTile> number_tiles(WorkSurface& surface, const SpecialBody& body);

/// Marks the curves between tiles, and the creases within them, on the surface's half-edges. Returns the curves that
/// these index.
std::vector<BodyCurve> draw_curves(WorkSurface& surface, const SpecialBody& body);

/// The name of a tile, `BODY-S03R02`: primitive, sector, ring, counted from 1; `BASE` or `TOP` as the ring on a
/// cone's flat ends. A further piece of the same cell has a letter: `BODY-S03R02b`.
std::string tile_name(const SpecialBody& body, const SpecialTile& tile);

/// The tiles as separate meshes, in order. A vertex on a seam has the same bits on both sides.
std::vector<NamedMesh> tile_meshes(const WorkSurface& surface, const SpecialBody& body,
                                   const std::vector<SpecialTile>& tiles);

}  // namespace ripstop
