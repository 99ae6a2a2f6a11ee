#pragma once

#include "ripstop/geometry/types.h"

namespace ripstop {

/// Triangles of a flat layout (#V x 2) that lie face down or have no area, or whose corners are not finite.
int count_flipped(const Triangles& triangles, const Points2& positions);

}  // namespace ripstop
