#pragma once

#include <optional>

#include "ripstop/mesh/triangle_mesh.h"

namespace ripstop {

/// A direction field on the cloth: one direction in space, or one per triangle, projected onto the triangles. Each is
/// given in the frame of its triangle (`lay_flat`) with unit length; zero if it is normal to the triangle (2 x #F).
struct ClothWarp {
    Eigen::Matrix2Xd along;
    bool laid_on_cloth = false;  ///< the projections cancelled on the cloth; one direction of the unrolled tile
                                 ///< replaces them
};

/// Projects `directions` (#F x 3, or one row for all) onto each triangle.
///
/// A piece has a single warp. On a tile that goes right round, a direction in space does not give one: on a tube it
/// runs clockwise on one side and counter-clockwise on the other, and these cancel on the cloth. Let A_t be the
/// areas, p_t the projections and w_t = p_t / |p_t|, rotated into the plane of the unrolled tile (`unroll`). If
///
///     |sum A_t w_t| < 0.3 sum A_t
///
/// the warp is a single direction of that plane for all triangles. It is the principal axis of the projections
/// regardless of sign, the eigenvector of the largest eigenvalue of sum A_t |p_t|² w_t w_tᵀ, so a horizontal
/// direction on a tube becomes its circumference. If they have no principal axis either (a ratio of the eigenvalues
/// below 1.9), it is the longest axis of the unrolled tile.
ClothWarp lay_on_cloth(const TriangleMesh& mesh, const Points3& directions);

/// The directions of `warp` in space (#F x 3), each rotated within its triangle by `angle`, counter-clockwise seen
/// from outside [rad].
Points3 warp_in_space(const TriangleMesh& mesh, const Eigen::Matrix2Xd& warp, double angle = 0);

/// The longest direction of the unrolled tile (its axis of largest second moment) in space, on the triangle nearest
/// the middle of the unrolled tile. Empty if the moments along and across agree to 10 %. It moves with the tile and
/// does not depend on the vertex numbering.
std::optional<Vec3> longest_axis_on_cloth(const TriangleMesh& mesh);

}  // namespace ripstop
