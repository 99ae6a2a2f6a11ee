#pragma once

#include <vector>

#include "ripstop/mesh/adjacency.h"

namespace ripstop {

/// Moves every interior vertex to the weighted mean of its neighbours: sum_j w_ij (u_j - u_i) = 0. The boundary (a
/// loop of vertices) is fixed. `weights`: one positive weight per edge, in the order of `Adjacency::edges`.
/// `positions` (#V x 2) is input and output. Returns false if the system cannot be solved; the interior vertices are
/// then unchanged. One sparse positive definite factorisation of size #interior vertices, none if there are none.
bool place_inside(const Adjacency& adjacency, const std::vector<int>& boundary, const Eigen::VectorXd& weights,
                  Points2& positions);

}  // namespace ripstop
