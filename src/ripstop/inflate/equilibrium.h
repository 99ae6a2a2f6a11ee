#pragma once

#include "ripstop/base/progress.h"
#include "ripstop/base/solve_summary.h"
#include "ripstop/inflate/balance.h"

namespace ripstop {

/// How `find_equilibrium` iterates and when it stops.
struct EquilibriumOptions {
    /// Shares of the unrelaxed cloth, one after the other; the last is the result's. Each is started from the one
    /// before.
    std::vector<double> residuals = {1e-4};
    int iterations = 300;     ///< of Newton's method, in all
    double tolerance = 1e-4;  ///< of the forces: their root mean square against the largest pressure on an edge squared
    /// Stiff cloth on a fine mesh chatters: wrinkles come and go by fractions of a millimetre long after the shape
    /// stands. Where ten steps together move the nodes by less than this share of the size (root mean square), and
    /// lower the energy by less than 5e-7 of it, with forces below 0.5 of the unit, that is at rest too. 0: never.
    double settled = 0;
    Progress progress = {};  ///< may throw to stop; nothing is kept then
};

/// Where an envelope is at rest, or where the iteration stopped: `summary` says which.
struct Equilibrium {
    Points3 nodes;        ///< #N x 3 [m]
    double energy = 0;    ///< Pi [J]
    double residual = 0;  ///< root mean square of the forces out of balance, in the unit of `tolerance`
    double residual_max = 0;
    bool is_stable = false;  ///< the last matrix was positive definite without a shift: the energy rises every way
    SolveSummary summary;
};

/// Moves the nodes from `start` to where the potential energy (`Balance`) is least nearby: Newton's method with the
/// exact matrix, shifted by a multiple of the identity where it is not positive definite or steps do not get through, a
/// search along each step (Armijo on the energy; on the forces once energy differences are rounding). Where it no
/// longer moves, `relax_dynamically` goes on, and from there cloth of a hundred times the residual stiffness.
/// Converged: root mean square of the forces below `tolerance`, the largest below ten times that; or `settled`, and the
/// reason says so. Sparse factorisations, one or two an iteration.
Equilibrium find_equilibrium(Balance& balance, const Points3& start, const EquilibriumOptions& options = {});

/// The slow way that always moves on: explicit steps with made-up masses (`Balance::fictitious_masses`), all speed
/// taken away whenever the kinetic energy has passed a peak (Day 1965; Barnes). No matrix. Stops at `tolerance` or
/// after `steps`.
Equilibrium relax_dynamically(const Balance& balance, const Points3& start, int steps, double tolerance);

/// What forces are measured against: the largest pressure times the mean edge squared [N].
double force_unit(const Balance& balance, const Points3& nodes);

}  // namespace ripstop
