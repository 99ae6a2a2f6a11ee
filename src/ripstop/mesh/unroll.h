#pragma once

#include <vector>

#include "ripstop/mesh/adjacency.h"
#include "ripstop/mesh/triangle_mesh.h"

namespace ripstop {

/// A triangle placed next to an earlier one: `corner` is its new corner.
struct LayingStep {
    int triangle = 0;
    int corner = 0;
};

/// The triangles in breadth-first order from `seed`, each with the corner that is new when it is placed across an
/// edge of an earlier one; the seed is first. #F steps on a connected mesh.
std::vector<LayingStep> laying_order(const Adjacency& adjacency, int seed);

/// The seed for unrolling: the triangle nearest the area centroid, the lowest if several are equally near.
int middle_triangle(const TriangleMesh& mesh);

/// The placement of a triangle in the plane: the point x of `lay_flat` (corner 0 at the origin, corner 1 on +x) lies
/// at `origin + turn x`.
struct LaidTriangle {
    Vec2 origin = Vec2::Zero();
    Mat22 turn = Mat22::Identity();
};

/// Unrolls the mesh (#F): the middle triangle is placed as by `lay_flat`, each other one rigidly beside the one from
/// which `laying_order` reaches it. On a developable disk all triangles fit together, and the result is its isometry;
/// elsewhere neighbours that are reached by different paths separate. Requires a connected mesh of triangles with
/// area. O(#F).
std::vector<LaidTriangle> unroll(const TriangleMesh& mesh, const Adjacency& adjacency);

}  // namespace ripstop
