#pragma once

#include <string>
#include <vector>

#include "ripstop/model/tile/envelope.h"

namespace ripstop {

/// Puts fair curves in the place of edges that zigzag (`find_zigzags`), the same on both sides of a seam.
///
/// Each vertex of a zigzag goes to its place on the fair curve: in the tile's flat layout (`flatten_dirichlet`) by
/// `fair_points`, in space by the same step along the edge and across it in the surface's tangent plane. Where a seam
/// ends and where a corner was given it stays. The neighbour's vertices there go to the same places. Of either tile the
/// vertices inside stay where they are, except those too near to the new edge or beyond it, which go; the triangles are
/// those of the Delaunay triangulation of the layout. Corners are sought anew, seams too; names, warp, compensation,
/// fabric and attributes stay, flat positions that came with the tile are dropped.
///
/// A tile stays as it is, and its neighbours along their zigzag, where each triangle has a warp of its own, where the
/// neighbour has other vertices along it, and where no mesh comes out. Returns a sentence for each tile: how far its
/// vertices moved and what became of its area, or why it stayed. About ten times as long as flattening those tiles.
std::vector<std::string> fair_seams(Envelope& envelope, double seam_tolerance);

}  // namespace ripstop
