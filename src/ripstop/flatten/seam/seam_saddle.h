#pragma once

#include "ripstop/flatten/seam/seam_newton.h"

namespace ripstop {

/// From a point at rest that is no minimum to one that is: where symmetry holds the cloth at a saddle, forces balance
/// and yet the energy falls to either side, and Newton's method, which only looks for balance, stays.
///
/// Takes the direction d that keeps the edges (J d = 0, R d = 0) and along which the energy falls,
///
///     dᵀ (H + sum lambda_i length_i'') d < 0
///
/// by a gradient iteration for the least curvature, the factorisation at `at` its preconditioner; goes along it as far
/// as the energy falls with the edges mended on the way, and minimises from there: below the saddle's energy, Newton
/// does not come back to it. Some five times at most. Returns `at` where it is a strict minimum, does not converge, or
/// no such direction shows; else the last point at rest, whose summary tells of all of it. Which of two mirror images
/// comes out depends on the shape alone, not on its numbering.
SeamSolution leave_saddles(const SeamProblem& problem, SeamNewton& newton, const SeamSolution& at,
                           const SeamNewtonOptions& options = {});

}  // namespace ripstop
