#pragma once

#include <Eigen/Geometry>

#include "ripstop/geometry/types.h"

namespace ripstop {

/// A triangulated surface: two arrays and nothing else. `Adjacency` gives its connectivity.
struct TriangleMesh {
    Points3 positions;    ///< #V x 3 [m]
    Triangles triangles;  ///< #F x 3, indices into positions, counter-clockwise seen from outside

    int vertex_count() const { return static_cast<int>(positions.rows()); }
    int triangle_count() const { return static_cast<int>(triangles.rows()); }
    Vec3 corner(int triangle, int k) const { return positions.row(triangles(triangle, k)); }
};

/// The area of one triangle, of each triangle (#F), and of the whole mesh [m2].
double triangle_area(const TriangleMesh& mesh, int triangle);
Eigen::VectorXd triangle_areas(const TriangleMesh& mesh);
double surface_area(const TriangleMesh& mesh);

/// The area vector (b - a) x (c - a) / 2 of one triangle [m2].
Vec3 area_vector(const TriangleMesh& mesh, int triangle);

/// The sum of the triangles' area vectors (b - a) x (c - a) / 2 [m2]: it points outward on average and is zero on a
/// closed surface.
Vec3 area_vector(const TriangleMesh& mesh);

/// The axis-aligned bounding box of all vertices, used or not; empty if there are none.
Eigen::AlignedBox3d box_of(const TriangleMesh& mesh);

/// Area-weighted centre of the surface [m].
Vec3 centroid(const TriangleMesh& mesh);

/// Length of the bounding box's diagonal [m].
double bounding_diagonal(const TriangleMesh& mesh);

}  // namespace ripstop
