#pragma once

#include "ripstop/flatten/seam/seam_newton.h"

namespace ripstop {

/// Where the iteration begins.
enum class SeamStart {
    boundary_first,  ///< the conformal map with an isometric boundary; the next where that turns triangles over
    arap,            ///< as rigid as possible, from a conformal map; Tutte's embedding where that turns triangles over
    lscm,            ///< the conformal map alone
    tutte,           ///< Tutte's embedding: a circle
};

/// Flat positions (2 #V) from which to bring the cloth to rest with its edges free: no triangle turned over. Not for
/// `boundary_first`, which is taken as `arap`. Requires a disk.
Eigen::VectorXd seam_start(const Tile& tile, SeamStart start);

/// The minimum of `problem` at its lengths: Newton from `loose`, and where that fails, the edges led from the lengths
/// they have there to those of the problem, in strides halved where one fails. Summary and certificate tell of all of
/// it; where the edges could not be led all the way, of where they stand, with `iteration_limit`.
SeamSolution hold_lengths(SeamProblem& problem, SeamNewton& newton, const Eigen::VectorXd& loose,
                          const SeamNewtonOptions& options = {});

/// Adds what an earlier run took.
void count_also(const SolveSummary& earlier, SolveSummary& summary);

}  // namespace ripstop
