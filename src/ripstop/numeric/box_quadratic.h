#pragma once

#include <Eigen/Core>
#include <optional>

#include "ripstop/numeric/symmetric_solver.h"

namespace ripstop {

/// The p that makes g·p + p·H p / 2 least within lower <= p <= upper (entries may be infinite), H positive definite and
/// sparse: `values` is its lower triangle in `pattern`, `solver` one of that pattern. Projected Newton [B82]: what
/// stands at a bound and is pushed against it rests, the others take a Newton step that is cut off at the bounds and
/// shortened until the value falls. Nothing where H is not positive definite on those that are free. Requires lower <=
/// 0 <= upper. One factorisation without bounds in the way, else one more for each change of what rests.
std::optional<Eigen::VectorXd> minimize_in_box(const SparsePattern& pattern, SymmetricSolver& solver,
                                               const Eigen::VectorXd& values, const Eigen::VectorXd& g,
                                               const Eigen::VectorXd& lower, const Eigen::VectorXd& upper);

/// What is left of the gradient g at x where a bound holds against it: zero at a minimum in the box.
Eigen::VectorXd free_gradient(const Eigen::VectorXd& g, const Eigen::VectorXd& x, const Eigen::VectorXd& lower,
                              const Eigen::VectorXd& upper);

}  // namespace ripstop
