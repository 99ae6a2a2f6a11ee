#pragma once

#include "ripstop/base/progress.h"
#include "ripstop/base/solve_summary.h"
#include "ripstop/inflate/balance.h"

namespace ripstop {

/// Options and stopping criteria of `find_equilibrium`.
struct EquilibriumOptions {
    /// Residual stiffnesses as fractions of the unrelaxed cloth, in sequence. Each starts from the previous result;
    /// the last one is the result.
    std::vector<double> residuals = {1e-4};
    int iterations = 300;     ///< Newton iterations in total
    double tolerance = 1e-4;  ///< root mean square of the forces, relative to the largest pressure times the mean edge
                              ///< squared
    /// Stiff cloth on a fine mesh chatters: wrinkles a fraction of a millimetre high appear and vanish long after the
    /// shape has converged. The iteration therefore also ends if ten steps together move the nodes by less than this
    /// fraction of the size (root mean square) and lower the energy by less than 5e-7 of it, and the forces are then
    /// below 0.5, in the unit of `tolerance`. 0: never.
    double settled = 0;
    Progress progress = {};  ///< may throw to cancel; no result is kept then
};

/// The equilibrium of an envelope, or the last state of the iteration: `summary` tells which.
struct Equilibrium {
    Points3 nodes;        ///< #N x 3 [m]
    double energy = 0;    ///< Pi [J]
    double residual = 0;  ///< root mean square of the unbalanced forces, in the unit of `tolerance`
    double residual_max = 0;
    bool is_stable = false;  ///< the last Hessian was positive definite without a shift: a strict minimum of the energy
    SolveSummary summary;
};

/// Minimises the potential energy (`Balance`) from `start`: Newton's method with the exact Hessian and a line search
/// (Armijo on the energy; on the forces once energy differences are rounding). If the Hessian is not positive
/// definite or steps fail, a multiple of the identity is added. If Newton stalls, it continues with
/// `relax_dynamically`, then with cloth of a hundred times the residual stiffness. Converged means that the root mean
/// square of the forces is below `tolerance` and the largest force below ten times that, or that the shape has
/// `settled`; the reason tells which. One or two sparse factorisations per iteration.
Equilibrium find_equilibrium(Balance& balance, const Points3& start, const EquilibriumOptions& options = {});

/// Dynamic relaxation (Day 1965; Barnes), slow but robust: explicit steps with fictitious masses
/// (`Balance::fictitious_masses`); all velocities are set to zero whenever the kinetic energy has passed a peak.
/// Needs no matrix. Stops at `tolerance` or after `steps`.
Equilibrium relax_dynamically(const Balance& balance, const Points3& start, int steps, double tolerance);

/// The unit of force residuals: the largest pressure times the mean edge squared [N].
double force_unit(const Balance& balance, const Points3& nodes);

}  // namespace ripstop
