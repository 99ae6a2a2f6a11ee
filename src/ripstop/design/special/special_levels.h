#pragma once

#include <utility>
#include <vector>

#include "ripstop/model/special/special_shape.h"

namespace ripstop {

/// A function of space and its gradient at a point.
struct Level {
    double value = 0;
    Vec3 gradient = Vec3::Zero();
};

/// Level of a primitive's part at a point of its own frame (its centre at 0, its axis along z); gradient in that frame.
Level part_level(const SpecialPrimitive& primitive, int part, const Vec3& x);

/// Heights of the planes between rings, from the lowest up; none for a torus.
std::vector<double> ring_heights(const SpecialPrimitive& primitive);

/// Half the extent of a primitive along each axis of the world, and the middle of it; `frame` has its own axes as rows.
std::pair<Vec3, Vec3> middle_and_reach(const SpecialPrimitive& primitive, const Eigen::Matrix3d& frame);

/// A ball that holds a primitive, and how much its level rises at least over the distance from it: by the least of an
/// ellipsoid's radii over its greatest; 0 where nothing is known (a cone's level past its tip).
struct LevelBall {
    Vec3 middle;
    double radius = 0;
    double rise = 0;
};
LevelBall ball_round(const SpecialPrimitive& primitive, const Eigen::Matrix3d& frame);

/// A primitive's own axes as rows.
Eigen::Matrix3d own_frame(const SpecialPrimitive& primitive);

}  // namespace ripstop
