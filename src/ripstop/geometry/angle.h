#pragma once

#include <cmath>

#include "ripstop/geometry/types.h"

namespace ripstop {

/// The angle between two directions, from 0 to pi: atan2(|a x b|, a . b), accurate for small angles too. Returns 0 if
/// either direction is zero.
inline double angle_between(const Vec3& a, const Vec3& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

}  // namespace ripstop
