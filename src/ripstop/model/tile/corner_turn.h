#pragma once

#include "ripstop/base/text/units.h"

namespace ripstop {

/// The allowance on corner angles for the rounding of coordinates in files [rad].
inline constexpr double corner_rounding = 1 * degree;

/// A larger turn is a corner, a smaller one a sample of a curve [rad]: 30 degrees, plus one for the rounding of
/// files. So a polygon of 12 sides is always a circle and one of 11 always has corners. The same angle holds for
/// edges in space (`ChainCurve`), edges on the surface (`make_tile`) and creases, so adjacent tiles agree on what
/// they share.
inline constexpr double corner_turn = 30 * degree + corner_rounding;

}  // namespace ripstop
