#pragma once

#include <optional>

#include "ripstop/mesh/triangle_mesh.h"

namespace ripstop {

/// A direction in space, or one of each triangle, laid onto the cloth: each in the frame of its triangle (`lay_flat`),
/// of unit length, zero where it stands on the triangle (2 x #F).
struct ClothWarp {
    Eigen::Matrix2Xd along;
    bool laid_on_cloth = false;  ///< the directions cancelled on the cloth: one direction of the unrolled tile instead
};

/// The part of `directions` (#F x 3, or one row for all) along each triangle.
///
/// A cut piece has one warp. On a tile that runs round, a direction in space gives none: laid onto a tube it runs
/// clockwise on one side and counter-clockwise on the other, and on the cloth these cancel. With w_t the parts turned
/// into the plane of the unrolled tile (`unroll`) and A_t the areas, where
///
///     |sum A_t w_t| < 0.3 sum A_t
///
/// the warp is one direction of that plane for all triangles: the axis along which most of the parts lie whichever way
/// they point, the greatest eigenvector of sum A_t |p_t|² w_t w_tᵀ (p_t before it is made a unit), so horizontal on a
/// tube is round it; where they have no axis either (eigenvalues as 1 to 1.9 or nearer), the longest axis of the
/// unrolled tile.
ClothWarp lay_on_cloth(const TriangleMesh& mesh, const Points3& directions);

/// The directions of `warp` in space (#F x 3), each turned within its triangle by `angle` counter-clockwise seen from
/// outside [rad].
Points3 warp_in_space(const TriangleMesh& mesh, const Eigen::Matrix2Xd& warp, double angle = 0);

/// The longest direction of the unrolled tile, its axis of greatest second moment, as it lies in space on the triangle
/// nearest the unrolled tile's middle; none where the moments along and across agree to 10 %. It moves with the tile
/// and does not care how vertices are numbered.
std::optional<Vec3> longest_axis_on_cloth(const TriangleMesh& mesh);

}  // namespace ripstop
