#pragma once

#include "ripstop/geometry/types.h"

namespace ripstop {

/// The longest step in (0, 1] along d that keeps 10 % of the way to the first triangle without area [SS15]: the
/// smallest positive root of the quadratics det(s) of all triangles. u and d are flat positions and their changes, x
/// and y of vertex after vertex (2 #V). O(#F).
double longest_step(const Triangles& triangles, const Eigen::VectorXd& u, const Eigen::VectorXd& d);

}  // namespace ripstop
