#pragma once

#include "ripstop/geometry/types.h"

namespace ripstop {

/// The side of the line a -> b on which c lies: 1 left, -1 right, 0 exactly on it. The result is exact.
///
/// It is the sign of (a - c) x (b - c). If the forward error bound of the two products (Shewchuk 1997) proves the
/// floating-point result, that is returned; otherwise the six products are summed exactly as an expansion of doubles.
/// Exact for coordinates that are zero or between 1e-140 and 1e140 in magnitude.
int orient2d(const Vec2& a, const Vec2& b, const Vec2& c);

}  // namespace ripstop
