#pragma once

#include <Eigen/Core>
#include <optional>

#include "ripstop/numeric/symmetric_solver.h"

namespace ripstop {

/// Minimizes g·p + p·H p / 2 over lower <= p <= upper (bounds may be infinite). H is sparse and positive definite;
/// `values` is its lower triangle in `pattern`, and `solver` is made for that pattern. Projected Newton [B82]: an
/// unknown that is pushed against its bound is active and stays; the others take a Newton step, clipped to the bounds
/// and shortened until the value falls. Empty if H is not positive definite on the free unknowns. Requires lower <= 0
/// <= upper. Costs one factorisation if no bound is reached, and one more for each change of the active set.
std::optional<Eigen::VectorXd> minimize_in_box(const SparsePattern& pattern, SymmetricSolver& solver,
                                               const Eigen::VectorXd& values, const Eigen::VectorXd& g,
                                               const Eigen::VectorXd& lower, const Eigen::VectorXd& upper);

/// The projected gradient: g at x without the components that push against a bound; zero at a minimum in the box.
Eigen::VectorXd free_gradient(const Eigen::VectorXd& g, const Eigen::VectorXd& x, const Eigen::VectorXd& lower,
                              const Eigen::VectorXd& upper);

}  // namespace ripstop
