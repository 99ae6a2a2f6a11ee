#pragma once

#include <functional>
#include <vector>

#include "ripstop/mesh/triangle_mesh.h"

/// Surfaces cut out along the edges of their mesh.
namespace ripstop::testing {

/// A lattice of equilateral triangles in the plane, with vertices moved at random.
struct Lattice {
    double edge = 0.1;    ///< [m]
    double half = 1;      ///< it covers the circle of this radius about the origin and a little more [m]
    double jumble = 0.2;  ///< random motion, as a share of an edge
    unsigned seed = 1;
};

/// The triangles of the lattice, sorted by `part_of` of their centres (0, 1, ...; -1: left out), each part mapped
/// into space.
std::vector<TriangleMesh> cut_along_mesh(const Lattice& lattice, const std::function<int(const Vec2&)>& part_of,
                                         const std::function<Vec3(const Vec2&)>& into_space);

/// The area-preserving map from the plane to a sphere of 10 m: a circle about the origin becomes a small circle
/// around +z.
Vec3 onto_sphere(const Vec2& point);

/// A disk of that sphere that contains this much curvature, cut along a mesh that is `across` edges from the
/// middle to the border. Cut smoothly, it would lose `curvature` / (4 pi) of its area if its border kept its
/// length.
TriangleMesh zigzag_disc(double curvature, double across, double jumble, unsigned seed);

}  // namespace ripstop::testing
