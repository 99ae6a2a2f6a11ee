#pragma once

#include <memory>

#include "ripstop/base/solve_summary.h"
#include "ripstop/flatten/seam/seam_problem.h"
#include "ripstop/flatten/seam/seam_step.h"

namespace ripstop {

struct SeamNewtonOptions {
    bool hold_edges = true;   ///< false: free boundary; only the grain (and the area) is constrained
    bool go_on = false;       ///< with edges held: start with the present factorisation (`system_at`), from nearby
    int max_iterations = 60;  ///< > 0
    double force_tolerance = 1e-8;    ///< largest unbalanced force, relative to E times the mean boundary edge
    double length_tolerance = 1e-11;  ///< largest remaining |length_i|, relative to l_i (`length_scales`)
};

/// A candidate for the first-order conditions, with the effort that it took.
struct SeamSolution {
    Eigen::VectorXd u;       ///< 2 #V [m]
    Eigen::VectorXd lambda;  ///< tension of each boundary edge: the force that holds it at its length [N]
    Eigen::VectorXd mu;      ///< multipliers of the grain and the area
    SolveSummary summary;
    double energy = 0;            ///< [J]
    double force_residual = 0;    ///< largest entry of grad energy + Jᵀ lambda, relative to E times the mean boundary
                                  ///< edge
    double length_residual = 0;   ///< largest |length_i| / l_i (`length_scales`)
    bool strict_minimum = false;  ///< edges held: the unmodified Hessian is positive definite along the constraints
};

/// Newton's method on the first-order conditions of `problem`, with a line search [NW06, ch. 18]:
///
///     [ H  Jᵀ ] [  d      ]     [ grad E ]
///     [ J  0  ] [ lambda' ] = - [   c    ]        H = Hessian of energy + lambda · length + mu · dense
///
/// The matrix H + rho Jᵀ J has the pattern of H and is factorised instead. For large rho it is positive definite
/// exactly if H is so along the constraints; the signs of its pivots certify that. With this one factorisation the
/// system above is solved by a few multiplier updates lambda += rho (J d + c), each of which reduces the error by a
/// factor of about 1/rho. Grain and area form a border of two columns. If a pivot is negative, the element Hessians
/// are clamped, then a multiple of the identity is added. Steps stop short of the first degenerate triangle and must
/// decrease an l1 merit function, with a second-order correction. After a full step with an unmodified matrix the
/// factorisation is reused (simplified Newton) as long as each step reduces the residual by a factor of ten: a solve
/// costs a tenth of a factorisation.
class SeamNewton {
  public:
    /// Analyses the problem's pattern once, for all calls of `minimize`. Keeps a reference to the problem.
    explicit SeamNewton(const SeamProblem& problem);
    ~SeamNewton();

    SeamSolution minimize(const Eigen::VectorXd& start, const SeamNewtonOptions& options = {});
    /// Starts from u, lambda and mu of `start`.
    SeamSolution minimize(const SeamSolution& start, const SeamNewtonOptions& options = {});

    /// The step with edges held, factorised at a solution; null if no shift makes it positive definite. Valid until
    /// the next call.
    const SeamStep* system_at(const SeamSolution& solution);

  private:
    class ForceBalance;
    ForceBalance settle(const SeamNewtonOptions& options, SeamSolution& at) const;

    const SeamProblem& problem_;
    std::unique_ptr<SeamStep> step_;
};

}  // namespace ripstop
