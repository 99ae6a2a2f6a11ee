#pragma once

#include <functional>
#include <vector>

#include "ripstop/mesh/triangle_mesh.h"

/// Surfaces cut out along the edges of their mesh.
namespace ripstop::testing {

/// A lattice of equilateral triangles in the plane, its vertices pushed about at random.
struct Lattice {
    double edge = 0.1;    ///< [m]
    double half = 1;      ///< it covers the circle of this radius round the origin and somewhat more [m]
    double jumble = 0.2;  ///< of an edge
    unsigned seed = 1;
};

/// Its triangles, sorted by `part_of` of their middles (0, 1, ...; -1: left out), each part carried into space.
std::vector<TriangleMesh> cut_along_mesh(const Lattice& lattice, const std::function<int(const Vec2&)>& part_of,
                                         const std::function<Vec3(const Vec2&)>& into_space);

/// From the plane onto a sphere of 10 m, areas kept: a circle round the origin becomes a small circle round +z.
Vec3 on_sphere(const Vec2& point);

/// A disc of that sphere with so much curvature in all, cut along a mesh that is `across` edges from the middle to the edge. Cut
/// smoothly it loses `curvature` / (4 pi) of its area where its edge keeps its length.
TriangleMesh zigzag_disc(double curvature, double across, double jumble, unsigned seed);

}  // namespace ripstop::testing
