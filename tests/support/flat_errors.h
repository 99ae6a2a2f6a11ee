#pragma once

#include <algorithm>
#include <cmath>

#include "ripstop/geometry/triangle.h"
#include "ripstop/mesh/boundary.h"
#include "ripstop/model/tile/tile.h"

/// Errors of a flattening, directly by their definitions.
namespace ripstop::testing {

/// The largest |L'/L - 1| over the edges of all triangles; zero only for an isometry.
inline double worst_edge_error(const TriangleMesh& mesh, const Points2& flat) {
    double worst = 0;
    for (int t = 0; t < mesh.triangle_count(); ++t)
        for (int k = 0; k < 3; ++k) {
            const int a = mesh.triangles(t, k), b = mesh.triangles(t, (k + 1) % 3);
            const double length = (mesh.positions.row(a) - mesh.positions.row(b)).norm();
            worst = std::max(worst, std::abs((flat.row(a) - flat.row(b)).norm() / length - 1));
        }
    return worst;
}

inline double flat_area(const TriangleMesh& mesh, const Points2& flat) {
    double area = 0;
    for (int t = 0; t < mesh.triangle_count(); ++t)
        area +=
            signed_area(flat.row(mesh.triangles(t, 0)), flat.row(mesh.triangles(t, 1)), flat.row(mesh.triangles(t, 2)));
    return area;
}

/// A'/A - 1 and L'/L - 1 of the whole tile and its whole boundary, signed.
inline double area_error(const Tile& tile, const Points2& flat) {
    return flat_area(tile.mesh, flat) / surface_area(tile.mesh) - 1;
}
inline double perimeter_error(const Tile& tile, const Points2& flat) {
    return edge_lengths(flat, closed(tile.boundary)).sum() /
               edge_lengths(tile.mesh.positions, closed(tile.boundary)).sum() -
           1;
}

/// The largest distance between corresponding vertices if either may be turned by half a turn: a grain line has no
/// direction.
inline double distance_up_to_half_turn(const Points2& one, const Points2& other) {
    return std::min((one - other).rowwise().norm().maxCoeff(), (one + other).rowwise().norm().maxCoeff());
}

}  // namespace ripstop::testing
