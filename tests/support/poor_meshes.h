#pragma once

#include "ripstop/mesh/triangle_mesh.h"

/// Meshes of a surface whose flat shape a good mesh gives.
namespace ripstop::testing {

/// A patch of the unit sphere, latitude and longitude within +-`half` [rad], as a grid of `columns` x `rows`
/// cells.
TriangleMesh sphere_grid(double half, int columns, int rows);

/// The same with a random diagonal in each cell.
TriangleMesh random_diagonals(double half, int columns, int rows, unsigned seed);

/// The same with interior vertices moved along the surface at random, by up to `share` of a cell.
TriangleMesh jumbled(double half, int columns, int rows, double share, unsigned seed);

/// The same with `extra` more vertices on every boundary edge, all on the surface, with a fan of needles.
TriangleMesh with_dense_boundary(double half, int columns, int rows, int extra);

/// The number of interior edges that join two boundary vertices and cut off more than one triangle.
int locked_edges(const TriangleMesh& mesh);

/// The smallest angle of all triangles [rad].
double least_angle(const TriangleMesh& mesh);

}  // namespace ripstop::testing
