#pragma once

#include <vector>

#include "ripstop/mesh/adjacency.h"
#include "ripstop/mesh/triangle_mesh.h"
#include "ripstop/mesh/unroll.h"

namespace ripstop {

/// The place of corner k of a triangle that is laid undeformed on its two other corners, where the circles round them
/// meet. If their edge is strained, the triangle is centred on it.
Vec2 laid_on(const TriangleMesh& mesh, const Points2& positions, int triangle, int k);

/// Lays a single triangle: corner 0 at the origin, corner 1 on +x.
void lay_first(const TriangleMesh& mesh, int triangle, Points2& positions);

/// Places the vertices that are not `placed` (#V), round by round outward from those that are. A vertex gets the
/// area-weighted mean of the places that its triangles with two placed corners give (`laid_on`). If nothing is placed
/// it starts with triangle `seed`. On a connected mesh all results are finite, and exact if the tile is developable.
/// O(#F) per round. Returns the number of vertices placed.
int lay_on_missing(const TriangleMesh& mesh, int seed, std::vector<bool> placed, Points2& positions);

/// Tries to unflip triangles by moving their vertices one at a time to places that the triangles or the neighbours
/// round them suggest, if that is an improvement. Makes at most `passes` passes and keeps the best result. The rest
/// of the tile is unchanged. Returns the number of triangles still flipped, never more than before.
int repair_flipped_triangles(const TriangleMesh& mesh, const Adjacency& adjacency, int passes, Points2& positions);

}  // namespace ripstop
