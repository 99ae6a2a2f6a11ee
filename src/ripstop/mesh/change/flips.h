#pragma once

#include "ripstop/geometry/types.h"

namespace ripstop {

/// The number of triangles of a flat layout (#V x 2) that are flipped, have no area or have non-finite corners.
int count_flipped(const Triangles& triangles, const Points2& positions);

}  // namespace ripstop
