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

/// The level of a primitive's part at a point of its local frame (centre at 0, axis along z); the gradient is in that
/// frame.
Level part_level(const SpecialPrimitive& primitive, int part, const Vec3& x);

/// Heights of the planes between rings, from the lowest up; none for a torus.
std::vector<double> ring_heights(const SpecialPrimitive& primitive);

/// The centre and the half extent of a primitive's bounding box in world axes; the rows of `frame` are its local
/// axes.
std::pair<Vec3, Vec3> middle_and_reach(const SpecialPrimitive& primitive, const Eigen::Matrix3d& frame);

/// A bounding ball of a primitive, and a lower bound on the slope of its level with the distance from it: for an
/// ellipsoid the smallest over the largest radius; 0 if unknown (a cone's level beyond its tip).
struct LevelBall {
    Vec3 middle;
    double radius = 0;
    double rise = 0;
};
LevelBall ball_round(const SpecialPrimitive& primitive, const Eigen::Matrix3d& frame);

/// The local axes of a primitive as rows.
Eigen::Matrix3d own_frame(const SpecialPrimitive& primitive);

}  // namespace ripstop
