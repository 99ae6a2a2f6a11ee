#pragma once

#include <vector>

#include "ripstop/mesh/adjacency.h"

namespace ripstop {

/// Puts every inner vertex in the weighted mean of its neighbours, the boundary (a loop of vertices) staying where it
/// is: sum_j w_ij (u_j - u_i) = 0. `weights`: one an edge, in the order of `Adjacency::edges`, positive. Positions #V
/// x 2, in and out. False where the system could not be solved: the inner vertices are left as they were. One sparse
/// positive definite factorisation of size #inner vertices, none if there are no such.
bool place_inside(const Adjacency& adjacency, const std::vector<int>& boundary, const Eigen::VectorXd& weights,
                  Points2& positions);

}  // namespace ripstop
