#pragma once

#include <Eigen/Core>

namespace ripstop {

/// Points, directions and small matrices of the plane and of space, in double.
using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Mat22 = Eigen::Matrix2d;
using Mat32 = Eigen::Matrix<double, 3, 2>;

using Points2 = Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>;  ///< #V x 2
using Points3 = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;  ///< #V x 3
using Triangles = Eigen::Matrix<int, Eigen::Dynamic, 3,
                                Eigen::RowMajor>;  ///< #F x 3, counter-clockwise from outside

}  // namespace ripstop
