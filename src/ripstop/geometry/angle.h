#pragma once

#include <cmath>

#include "ripstop/geometry/types.h"

namespace ripstop {

/// The angle between two directions, from 0 to pi: atan2(|a x b|, a . b), exact for small angles too. 0 where one is
/// zero.
inline double angle_between(const Vec3& a, const Vec3& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

}  // namespace ripstop
