#pragma once

#include <vector>

#include "ripstop/mesh/adjacency.h"
#include "ripstop/mesh/triangle_mesh.h"

namespace ripstop {

/// A triangle laid beside those before it: its corner `corner` is the new one.
struct LayingStep {
    int triangle = 0;
    int corner = 0;
};

/// The triangles one by one outward from `seed`, each across an edge of one before it; the first is the seed. #F steps
/// on a connected mesh.
std::vector<LayingStep> laying_order(const Adjacency& adjacency, int seed);

/// The triangle nearest the area centre: the seed. Among those equally near, the lowest.
int middle_triangle(const TriangleMesh& mesh);

/// Where a triangle lies in the plane: the point x of `lay_flat` (corner 0 at the origin, corner 1 on +x) at
/// `origin + turn x`.
struct LaidTriangle {
    Vec2 origin = Vec2::Zero();
    Mat22 turn = Mat22::Identity();
};

/// The mesh unrolled (#F): the middle triangle as `lay_flat` has it, each other one moved rigidly to lie beside the one
/// from which `laying_order` reaches it. On a developable disk all triangles fit together and this is its isometry;
/// elsewhere neighbours reached by different ways part. Requires a connected mesh of triangles with area. O(#F).
std::vector<LaidTriangle> unroll(const TriangleMesh& mesh, const Adjacency& adjacency);

}  // namespace ripstop
