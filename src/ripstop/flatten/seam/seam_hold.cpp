#include "ripstop/flatten/seam/seam_hold.h"

#include <algorithm>
#include <limits>

#include "ripstop/base/text/number_text.h"
#include "ripstop/flatten/map/arap.h"
#include "ripstop/flatten/map/lscm.h"
#include "ripstop/flatten/map/tutte.h"
#include "ripstop/mesh/change/flips.h"
#include "ripstop/tile/allowance.h"

namespace ripstop {
namespace {

using Vector = Eigen::VectorXd;

Points2 starting_positions(const Tile& tile, SeamStart start) {
    if (start != SeamStart::tutte) {
        Flattening flat = flatten_lscm(tile);
        if (start != SeamStart::lscm && flat.summary.usable())
            flat = flatten_arap(tile, flat.positions, {.max_iterations = 4, .tolerance = 1e-3});
        if (flat.summary.usable() && count_flipped(tile.mesh.triangles, flat.positions) == 0) return flat.positions;
    }
    return flatten_tutte(tile).positions;
}

/// Continuation: changes the edge lengths in steps from the present to the true ones; halves the step when it fails.
SeamSolution lead_lengths(SeamProblem& problem, SeamNewton& newton, const SeamNewtonOptions& options,
                          const Vector& start) {
    const Vector true_lengths = problem.lengths(), free_lengths = problem.flat_lengths(start);
    SeamSolution at;
    at.u = start;
    at.lambda = Vector::Zero(problem.edge_count());
    at.mu = Vector::Zero(problem.dense_count());
    double reached = 0, stride = 0.25;
    int iterations = 0, factorizations = 0;
    while (reached < 1 && stride > 0.04) {
        const double next = std::min(1.0, reached + stride);
        problem.set_lengths((1 - next) * free_lengths + next * true_lengths);
        SeamSolution there = newton.minimize(at.u, options);
        iterations += there.summary.iterations;
        factorizations += there.summary.factorizations;
        if (there.summary.termination == Termination::converged) {
            at = std::move(there);
            reached = next;
            stride *= 1.5;
        } else {
            stride *= 0.5;
        }
    }
    problem.set_lengths(true_lengths);
    at.summary.iterations = iterations;
    at.summary.factorizations = factorizations;
    if (reached < 1) {
        at.summary.termination = Termination::iteration_limit;
        at.summary.reason =
            "the edges reached only " + format_fixed(100 * reached, 0) + " % of the way to their lengths";
        at.strict_minimum = false;  // it was another problem that converged
        at.force_residual = std::numeric_limits<double>::quiet_NaN();
        at.length_residual =
            problem.edge_residual(at.u).cwiseQuotient(problem.length_scales()).lpNorm<Eigen::Infinity>();
    }
    return at;
}

}  // namespace

void count_also(const SolveSummary& earlier, SolveSummary& summary) {
    summary.iterations += earlier.iterations;
    summary.factorizations += earlier.factorizations;
}

Vector seam_start(const Tile& tile, SeamStart start) {
    const Points2 positions = starting_positions(tile, start);
    return Eigen::Map<const Vector>(positions.data(), positions.size());
}

SeamSolution hold_lengths(SeamProblem& problem, SeamNewton& newton, const Vector& loose,
                          const SeamNewtonOptions& options) {
    SeamSolution held = newton.minimize(loose, options);
    if (held.summary.termination == Termination::converged) return held;
    SeamSolution led = lead_lengths(problem, newton, options, loose);
    count_also(held.summary, led.summary);
    return led;
}

}  // namespace ripstop
