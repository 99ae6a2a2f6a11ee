#pragma once

#include <vector>

#include "ripstop/model/tile/tile.h"

namespace ripstop {

/// The warp in the frame of each triangle (2 x #F): its projection onto the triangle in the basis of `lay_flat`, with
/// unit length; zero if the warp is normal to the triangle. On a tile that goes right round, where these would
/// cancel, it is one direction on the cloth (`lay_on_cloth`).
Eigen::Matrix2Xd warp_in_triangles(const Tile& tile);

/// The target shape of each triangle on the cloth (#F): the triangle laid flat (`lay_flat`), scaled along warp and
/// weft by the compensation. Without compensation it is the triangle of the surface.
std::vector<Mat22> target_triangles(const Tile& tile);

/// The drawn length of each boundary edge, boundary[i] to boundary[i + 1] [m]: along its seam's curve if that is
/// known.
Eigen::VectorXd drawn_lengths(const Tile& tile);

/// The target length of each boundary edge on the cloth [m]: the drawn length with compensation.
Eigen::VectorXd target_lengths(const Tile& tile);

}  // namespace ripstop
