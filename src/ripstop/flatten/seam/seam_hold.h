#pragma once

#include "ripstop/flatten/seam/seam_newton.h"

namespace ripstop {

/// The initial positions of the iteration.
enum class SeamStart {
    boundary_first,  ///< the conformal map with an isometric boundary; `arap` if that flips triangles
    arap,            ///< as rigid as possible, from a conformal map; Tutte's embedding if that flips triangles
    lscm,            ///< the conformal map
    tutte,           ///< Tutte's embedding: a circle
};

/// Flat positions (2 #V) without flipped triangles, from which to minimise the energy with free edges.
/// `boundary_first` is treated as `arap`. Requires a disk.
Eigen::VectorXd seam_start(const Tile& tile, SeamStart start);

/// The minimum of `problem` at its edge lengths, by Newton's method from `loose`. If that fails, continuation: the edge
/// lengths change in steps from those of `loose` to those of the problem, and a failed step is halved. Summary and
/// certificate cover all runs. If continuation does not reach the lengths of the problem, both describe the last point
/// reached, with `iteration_limit`.
SeamSolution hold_lengths(SeamProblem& problem, SeamNewton& newton, const Eigen::VectorXd& loose,
                          const SeamNewtonOptions& options = {});

/// Adds the iterations and factorisations of an earlier run.
void count_also(const SolveSummary& earlier, SolveSummary& summary);

}  // namespace ripstop
