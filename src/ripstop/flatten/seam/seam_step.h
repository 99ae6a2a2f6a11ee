#pragma once

#include <Eigen/Core>
#include <vector>

#include "ripstop/flatten/seam/seam_problem.h"
#include "ripstop/numeric/symmetric_solver.h"

namespace ripstop {

/// One Newton step of a seam problem: assembles, factorises and solves
///
///     [ H  Jᵀ  Rᵀ ] [ d      ]     [ g ]
///     [ J         ] [ lambda ] = - [ c ]        J rows of the edges, R of the grain (and the area)
///     [ R         ] [ mu     ]     [ r ]
///
/// where g is the gradient, and c and r are the residuals at u. The matrix H + rho Jᵀ J has the pattern of H and is
/// factorised instead. For large rho it is positive definite exactly if H is so along the edge constraints; the signs
/// of its pivots certify that. A few multiplier updates lambda += rho (J d + c) then satisfy the edges, each reducing
/// their error by a factor of about 1e-5. R and the rotation constraint form a border of two or three columns, solved
/// in one pass with the first update.
class SeamStep {
  public:
    /// Analyses the pattern. Keeps a reference to the problem.
    explicit SeamStep(const SeamProblem& problem);

    /// False makes the boundary free: J is left out.
    void hold_edges(bool hold);

    /// Factorises at u. If the Hessian is not positive definite along the constraints, its elements are clamped and,
    /// if necessary, an increasing multiple of the identity is added. If `near` rest, the identity is tried first: a
    /// small multiple hardly slows the convergence. Returns false if no multiple suffices.
    bool factorize(const Eigen::VectorXd& u, const Eigen::VectorXd& lambda, const Eigen::VectorXd& mu, bool near);

    double energy() const { return energy_; }                      ///< energy at the last u [J]
    const Eigen::VectorXd& gradient() const { return gradient_; }  ///< gradient of the energy there
    bool exact() const { return exact_; }  ///< the matrix was not modified: the constrained minimum is strict
    int factorizations() const { return solver_.factorizations(); }

    struct Solution {
        Eigen::VectorXd d, lambda, mu;
    };
    /// The Newton step at the last u.
    Solution step() const;

    /// The correction for unbalanced forces g and residuals c, r at a point nearby; lambda and mu are increments of
    /// the multipliers.
    Solution correction(const Eigen::VectorXd& g, const Eigen::VectorXd& c, const Eigen::VectorXd& r) const;

    /// The Jacobian of the edge tensions with respect to the edge lengths (#edges x #edges, symmetric): S = (J H⁻¹
    /// Jᵀ)⁻¹ along R = 0, the stiffness of the tile condensed to its edges. One solve per edge and a dense inverse.
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
    Eigen::VectorXd first_;  ///< Newton step before the border and the updates
    double energy_ = 0;
    int held_turn_ = 0;
    Eigen::MatrixXd columns_, solved_, schur_;
    bool clamped_ = false;  ///< the last matrix needed clamping: start with clamped elements
    double shift_ = 0;
    bool exact_ = false;
};

}  // namespace ripstop
