#pragma once

#include <string>
#include <vector>

#include "ripstop/model/tile/envelope.h"

namespace ripstop {

/// Replaces zigzag edges (`find_zigzags`) by fair curves, the same on both sides of a seam.
///
/// Each vertex of a zigzag moves to its place on the fair curve: in the tile's flat layout (`flatten_dirichlet`) by
/// `fair_points`, and in space by the same displacement along the edge and across it in the tangent plane of the
/// surface. Ends of seams and given corners stay. The neighbour's vertices move to the same places. Inner vertices of
/// both tiles stay, except those too close to the new edge or beyond it, which are removed. The new triangles are the
/// Delaunay triangulation of the layout. Corners and seams are searched again. Names, warp, compensation, fabric and
/// attributes are kept; flat positions that came with the tile are dropped.
///
/// A tile and its neighbours along the zigzag are unchanged if each triangle has a warp of its own, if the neighbour
/// has other vertices along the zigzag, or if the mesh fails. Returns one sentence for each tile: how far its vertices
/// moved and how its area changed, or why it is unchanged. Takes about ten times as long as flattening those tiles.
std::vector<std::string> fair_seams(Envelope& envelope, double seam_tolerance);

}  // namespace ripstop
