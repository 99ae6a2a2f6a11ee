#pragma once

#include "ripstop/base/text/units.h"

namespace ripstop {

/// What turns by more is meant as a corner, what turns by less samples a curve [rad]: 30 degrees, and a degree more for
/// the rounding of files. The polygon of 12 sides is a circle however it was written, that of 11 has corners. One angle
/// for edges in space (`ChainCurve`), edges on the surface (`make_tile`) and creases, so that what two tiles share is
/// the same for both.
inline constexpr double corner_rounding = 1 * degree;
inline constexpr double corner_turn = 30 * degree + corner_rounding;

}  // namespace ripstop
