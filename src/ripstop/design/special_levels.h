#pragma once

#include "ripstop/design/special_body.h"

namespace ripstop {

/// Level of a primitive's part at a point of its own frame (its centre at 0, its axis along z); gradient in that frame.
Level part_level(const SpecialPrimitive& primitive, int part, const Vec3& x);

/// Heights of the planes between rings, from the lowest up; none for a torus.
std::vector<double> ring_heights(const SpecialPrimitive& primitive);

/// Half the extent of a primitive along each axis of the world, and the middle of it; `frame` has its own axes as rows.
std::pair<Vec3, Vec3> middle_and_reach(const SpecialPrimitive& primitive, const Eigen::Matrix3d& frame);

/// A primitive's own axes as rows.
Eigen::Matrix3d own_frame(const SpecialPrimitive& primitive);

}  // namespace ripstop
