#pragma once

#include "ripstop/geometry/types.h"

namespace ripstop {

/// The longest step in (0, 1] along d that stops 10 % short of the first degenerate triangle [SS15]: 0.9 times the
/// smallest positive root of the quadratics det(s) of all triangles. u and d are flat positions and their changes
/// (2 #V, x and y of each vertex in turn). O(#F).
double longest_step(const Triangles& triangles, const Eigen::VectorXd& u, const Eigen::VectorXd& d);

}  // namespace ripstop
