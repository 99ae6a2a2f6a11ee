#pragma once

#include <Eigen/Core>
#include <vector>

#include "ripstop/flatten/seam/seam_problem.h"
#include "ripstop/numeric/symmetric_solver.h"

namespace ripstop {

/// One Newton step of a seam problem: assembles, factorises, and solves
///
///     [ H  Jᵀ  Rᵀ ] [ d      ]     [ g ]
///     [ J         ] [ lambda ] = - [ c ]        J rows of the edges, R of the grain (and the area)
///     [ R         ] [ mu     ]     [ r ]
///
/// g the gradient, c and r the residuals at u. What is factorised is H + rho Jᵀ J, which has the pattern of H and is
/// positive definite exactly where H is so along the edges' constraints (rho large); its pivots' signs certify that.
/// The edges then take a few multiplier updates lambda += rho (J d + c), each bringing about a factor of 1e-5; R and
/// the hold against turning are a border of two or three columns, solved in one pass with the first of them.
class SeamStep {
  public:
    /// Analyses the pattern. Keeps a reference to the problem.
    explicit SeamStep(const SeamProblem& problem);

    /// False: a free boundary, J is left out.
    void hold_edges(bool hold);

    /// Factorises at u. Where the Hessian is not positive definite along the constraints, its elements are clamped and,
    /// if that is not enough, a growing multiple of the identity is added; `near` rest the multiple goes first, as it
    /// may be small and then hardly slows the convergence. False where no amount does.
    bool factorize(const Eigen::VectorXd& u, const Eigen::VectorXd& lambda, const Eigen::VectorXd& mu, bool near);

    double energy() const { return energy_; }                      ///< at the last u [J]
    const Eigen::VectorXd& gradient() const { return gradient_; }  ///< of the energy there
    bool exact() const { return exact_; }  ///< nothing was clamped or added: the constrained minimum is strict
    int factorizations() const { return solver_.factorizations(); }

    struct Solution {
        Eigen::VectorXd d, lambda, mu;
    };
    /// The Newton step at the last u.
    Solution step() const;

    /// The step that takes away forces g out of balance and residuals c, r met elsewhere, nearby; lambda and mu are
    /// what it adds to the multipliers.
    Solution correction(const Eigen::VectorXd& g, const Eigen::VectorXd& c, const Eigen::VectorXd& r) const;

    /// How the tensions answer the lengths (#edges x #edges, symmetric): S = (J H⁻¹ Jᵀ)⁻¹ along R = 0, the stiffness of
    /// the tile as its edges feel it. One solve an edge, and a dense inverse.
    Eigen::MatrixXd edge_stiffness() const;

  private:
    void hold_still();
    bool border();
    Eigen::VectorXd right_side(const Eigen::VectorXd& g, const Eigen::VectorXd& lambda, const Eigen::VectorXd& c) const;
    void add_border(const Eigen::VectorXd& r, Solution& solution) const;
    void update_multipliers(const Eigen::VectorXd& g, const Eigen::VectorXd& c, const Eigen::VectorXd& r,
                            Solution& solution) const;

    const SeamProblem& problem_;
    SymmetricSolver solver_;
    bool hold_edges_ = true;
    double rho_ = 0;
    Eigen::VectorXd u_, lambda_, gradient_, values_;
    Eigen::VectorXd edge_residual_, dense_residual_;
    Eigen::VectorXd first_;  ///< of the Newton step, before the border and the updates
    double energy_ = 0;
    int held_turn_ = 0;
    Eigen::MatrixXd columns_, solved_, schur_;
    bool clamped_ = false;  ///< the last matrix needed it: begin with clamped elements
    double shift_ = 0;
    bool exact_ = false;
};

}  // namespace ripstop
