#pragma once

#include "ripstop/flatten/seam/seam_newton.h"

namespace ripstop {

/// Continues from a saddle to a minimum. At a saddle, where symmetry may hold the cloth, forces balance but the
/// energy falls to either side; Newton's method only finds balance and stays there.
///
/// Finds a direction d that keeps the edges (J d = 0, R d = 0) and has negative curvature,
///
///     dᵀ (H + sum lambda_i length_i'') d < 0
///
/// by a gradient iteration for the least curvature, preconditioned with the factorisation at `at`. It moves along d
/// as far as the energy falls, correcting the edges on the way, and minimises from there. Newton does not return,
/// because the energy is below that of the saddle. At most about five rounds. Returns `at` if it is a strict minimum,
/// has not converged or no such direction is found; otherwise the last converged point, whose summary covers all
/// rounds. Which of two mirror images results depends on the shape only, not on its numbering.
SeamSolution leave_saddles(const SeamProblem& problem, SeamNewton& newton, const SeamSolution& at,
                           const SeamNewtonOptions& options = {});

}  // namespace ripstop
