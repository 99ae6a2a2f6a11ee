#pragma once

#include <vector>

#include "ripstop/mesh/adjacency.h"
#include "ripstop/mesh/triangle_mesh.h"
#include "ripstop/mesh/unroll.h"

namespace ripstop {

/// Where corner k of a triangle lies if the triangle is laid unstrained on its two other corners: where the circles
/// round them meet. On the middle of their edge, if that is strained.
Vec2 laid_on(const TriangleMesh& mesh, const Points2& positions, int triangle, int k);

/// Lays a triangle alone: corner 0 at the origin, corner 1 on +x.
void lay_first(const TriangleMesh& mesh, int triangle, Points2& positions);

/// Gives the vertices that are not `placed` (#V) flat positions, round by round outward from those that are: each as
/// its triangles say that have two corners in place, laid on them unstrained, averaged by area. If nothing is placed
/// it begins with triangle `seed`. Every vertex of a connected mesh comes out finite and exact if the tile is
/// developable. O(#F) a round. Returns how many it placed.
int lay_on_missing(const TriangleMesh& mesh, int seed, std::vector<bool> placed, Points2& positions);

/// Tries to turn flipped triangles back by moving their vertices one at a time to where the triangles round them or
/// their neighbours would have them, where that makes it better there; goes over them at most `passes` times and keeps
/// the best. Leaves the rest of the tile as it is. Returns how many are still flipped: never more than before.
int repair_flipped_triangles(const TriangleMesh& mesh, const Adjacency& adjacency, int passes, Points2& positions);

}  // namespace ripstop
