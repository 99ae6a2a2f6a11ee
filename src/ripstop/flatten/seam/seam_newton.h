#pragma once

#include <memory>

#include "ripstop/base/solve_summary.h"
#include "ripstop/flatten/seam/seam_problem.h"
#include "ripstop/flatten/seam/seam_step.h"

namespace ripstop {

struct SeamNewtonOptions {
    bool hold_edges = true;           ///< false: a free boundary, only the grain (and the area) is held
    bool go_on = false;               ///< edges held: begin with the factorisation at hand (`system_at`), from nearby
    int max_iterations = 60;          ///< > 0
    double force_tolerance = 1e-8;    ///< largest force out of balance, in E times the mean boundary edge
    double length_tolerance = 1e-11;  ///< largest |length_i| left, in l_i (`length_scales`)
};

/// A point that may satisfy the first-order conditions, with what it took.
struct SeamSolution {
    Eigen::VectorXd u;       ///< 2 #V [m]
    Eigen::VectorXd lambda;  ///< tension of each boundary edge: the force that holds it at its length [N]
    Eigen::VectorXd mu;      ///< of the grain and the area
    SolveSummary summary;
    double energy = 0;            ///< [J]
    double force_residual = 0;    ///< largest entry of grad energy + Jᵀ lambda, in E times the mean boundary edge
    double length_residual = 0;   ///< largest |length_i| / l_i (`length_scales`)
    bool strict_minimum = false;  ///< edges held: the Hessian is positive definite along the constraints, nothing added
};

/// Newton's method on the first-order conditions of `problem`, with line search [NW06, ch. 18]:
///
///     [ H  Jᵀ ] [  d      ]     [ grad E ]
///     [ J  0  ] [ lambda' ] = - [   c    ]        H = Hessian of energy + lambda · length + mu · dense
///
/// H + rho Jᵀ J has the pattern of H, so that is what is factorised: it is positive definite exactly where H is so
/// along the constraints (rho large), which its pivots' signs certify. The system above is solved by a few multiplier
/// updates lambda += rho (J d + c) with that one factorisation, each 1/rho closer; grain and area by a border of two
/// columns. Where a pivot is negative the element Hessians are clamped, then a multiple of the identity is added. Steps
/// stop short of the first triangle that would lose its area, then satisfy an l1 merit with a second-order correction.
/// After a whole step with nothing clamped or added the same factorisation serves again (simplified Newton), as long as
/// a step takes a decade off what is out of balance: a solve costs a tenth of a factorisation.
class SeamNewton {
  public:
    /// Analyses the problem's pattern once, for every `minimize`. Keeps a reference to the problem.
    explicit SeamNewton(const SeamProblem& problem);
    ~SeamNewton();

    SeamSolution minimize(const Eigen::VectorXd& start, const SeamNewtonOptions& options = {});
    /// Begins with u, lambda and mu of `start`.
    SeamSolution minimize(const SeamSolution& start, const SeamNewtonOptions& options = {});

    /// The step with edges held, factorised at a solution; null where no shift makes that possible. Valid until the
    /// next call.
    const SeamStep* system_at(const SeamSolution& solution);

  private:
    class Balance;
    Balance settle(const SeamNewtonOptions& options, SeamSolution& at) const;

    const SeamProblem& problem_;
    std::unique_ptr<SeamStep> step_;
};

}  // namespace ripstop
