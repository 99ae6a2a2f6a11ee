#pragma once

#include <string>
#include <vector>

#include "ripstop/design/special/special_surface.h"
#include "ripstop/model/tile/cad_model.h"

namespace ripstop {

/// What becomes a tile: the connected triangles of a cell, with what was too small to be one by itself.
struct SpecialTile {
    BodyCell cell;
    int nth = 0;  ///< of the tiles in that cell
};

/// Numbers the tiles in `surface.tile` (-1: below the mouth). A piece of less than a twentieth of the median area goes
/// to the neighbour it has the longest border with, of those on its own face if there are any. Sorted by primitive,
/// part, sector and ring. O(#F log #F).
std::vector<SpecialTile> number_tiles(WorkSurface& surface, const SpecialBody& body);

/// Draws the curves between tiles, and the creases within, on the surface's half-edges, and returns what these count.
std::vector<BodyCurve> draw_curves(WorkSurface& surface, const SpecialBody& body);

/// `BODY-S03R02`: primitive, sector, ring, counted from 1; `BASE` or `TOP` for the ring on a cone's flat ends; a
/// further piece of the same cell has a letter: `BODY-S03R02b`.
std::string tile_name(const SpecialBody& body, const SpecialTile& tile);

/// The tiles as meshes of their own, in order. A vertex on a seam is the same bits on both sides.
std::vector<NamedMesh> tile_meshes(const WorkSurface& surface, const SpecialBody& body,
                                   const std::vector<SpecialTile>& tiles);

}  // namespace ripstop
