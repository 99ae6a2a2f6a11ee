#include "ripstop/flatten/seam_exact.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "ripstop/base/error.h"
#include "ripstop/base/number_text.h"
#include "ripstop/base/units.h"
#include "ripstop/flatten/arap.h"
#include "ripstop/flatten/boundary_first.h"
#include "ripstop/flatten/coarse_start.h"
#include "ripstop/flatten/grain.h"
#include "ripstop/flatten/lscm.h"
#include "ripstop/flatten/seam_newton.h"
#include "ripstop/flatten/tutte.h"
#include "ripstop/mesh/flips.h"

namespace ripstop {
namespace {

using Vector = Eigen::VectorXd;

constexpr int coarse_start_from =
    5'000;                             ///< triangles: of smaller tiles the coarse cloth would cost as much as it saves
constexpr int direct_iterations = 20;  ///< from the boundary's own lengths; what needs more is better led there

bool without_flips(const Tile& tile, const Flattening& flat) {
    return flat.summary.usable() && count_flipped(tile.mesh.triangles, flat.positions) == 0;
}

Points2 starting_positions(const Tile& tile, SeamStart start) {
    if (start != SeamStart::tutte) {
        Flattening flat = flatten_lscm(tile);
        if (start != SeamStart::lscm && flat.summary.usable())
            flat = flatten_arap(tile, flat.positions, {.max_iterations = 4, .tolerance = 1e-3});
        if (without_flips(tile, flat)) return flat.positions;
    }
    return flatten_tutte(tile).positions;
}

void count_also(const SolveSummary& earlier, SolveSummary& summary) {
    summary.iterations += earlier.iterations;
    summary.factorizations += earlier.factorizations;
}

Vector as_vector(const Points2& positions) {
    return Eigen::Map<const Vector>(positions.data(), positions.size());
}

Vector lengths_at(const Tile& tile, const Vector& u) {
    const Points2 positions = Eigen::Map<const Points2>(u.data(), u.size() / 2, 2);
    return edge_lengths(positions, closed(tile.boundary));
}

/// Leads the edges from the lengths they have to the true ones, halving the stride where a step fails.
SeamSolution lead_lengths(SeamProblem& problem, SeamNewton& newton, const SeamNewtonOptions& options,
                          const Vector& start, const Vector& free_lengths, const Vector& true_lengths) {
    SeamSolution at;
    at.u = start;
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
            "the edges could be led only " + format_fixed(100 * reached, 0) + " % of the way to their lengths";
        at.strict_minimum = false;  // what converged was another problem
        at.force_residual = std::numeric_limits<double>::quiet_NaN();
        at.length_residual = problem.edge_residual(at.u).cwiseQuotient(true_lengths).lpNorm<Eigen::Infinity>();
    }
    return at;
}

double largest_thread_strain(const Tile& tile, const Points2& positions) {
    const std::vector<Mat22> targets = target_triangles(tile);
    double largest = 0;
    for (std::size_t t = 0; t < targets.size(); ++t) {
        const ThreadStrain strain =
            thread_strain(triangle_metric(targets[t]), flat_edges(tile.mesh.triangles, positions, static_cast<int>(t)));
        largest = std::max({largest, std::abs(strain.warp), std::abs(strain.weft)});
    }
    return largest;
}

/// What holding the area costs the threads, beside the same flattening without it.
std::string price_of_area(const Tile& tile, const Fabric& fabric, SeamExactOptions options, const Points2& positions) {
    options.keep_area = false;
    const Flattening plain = flatten_seam_exact(tile, fabric, options);
    return "holding the whole area takes the largest thread strain from " +
           format_fixed(largest_thread_strain(tile, plain.positions) / percent, 3) + " to " +
           format_fixed(largest_thread_strain(tile, positions) / percent, 3) + " %";
}

/// From a start whose edges are nearly right straight to the end; empty where that turns triangles over.
std::optional<SeamSolution> from_boundary(const Tile& tile, const Fabric& fabric, SeamNewton& newton) {
    const Flattening flat = flatten_boundary_first(tile);
    if (!without_flips(tile, flat)) return std::nullopt;
    const bool large = tile.mesh.triangle_count() >= coarse_start_from;
    return newton.minimize(as_vector(large ? coarse_solution(tile, fabric, flat.positions) : flat.positions),
                           {.max_iterations = direct_iterations});
}

/// From the cloth at rest without its edges held.
SeamSolution from_rest(const Tile& tile, SeamProblem& problem, SeamNewton& newton, const SeamExactOptions& options) {
    const Vector true_lengths = problem.lengths();
    const SeamNewtonOptions free{
        .hold_edges = false, .max_iterations = options.max_iterations, .force_tolerance = 1e-3};
    const SeamSolution loose = newton.minimize(as_vector(starting_positions(tile, options.start)), free);
    const SeamNewtonOptions held{.max_iterations = options.max_iterations};
    SeamSolution exact = newton.minimize(loose.u, held);
    count_also(loose.summary, exact.summary);
    if (exact.summary.termination == Termination::converged) return exact;
    const double outline = true_lengths.sum();
    if (options.keep_area && outline * outline < 4 * std::numbers::pi * problem.size() * problem.size()) {
        exact.summary.reason = "no outline of this length encloses the whole area";
        return exact;
    }
    SeamSolution led = lead_lengths(problem, newton, held, loose.u, lengths_at(tile, loose.u), true_lengths);
    count_also(exact.summary, led.summary);
    return led;
}

SeamSolution solve(const Tile& tile, const Fabric& fabric, SeamProblem& problem, SeamNewton& newton,
                   const SeamExactOptions& options) {
    SolveSummary spent;
    if (options.start == SeamStart::boundary_first) {
        std::optional<SeamSolution> exact = from_boundary(tile, fabric, newton);
        if (exact && exact->summary.termination == Termination::converged && exact->strict_minimum) return *exact;
        if (exact) spent = exact->summary;
    }
    SeamSolution exact = from_rest(tile, problem, newton, options);
    count_also(spent, exact.summary);
    return exact;
}

}  // namespace

Flattening flatten_seam_exact(const Tile& tile, const Fabric& fabric, const SeamExactOptions& options) {
    if (!(options.bending >= 0) || options.max_iterations <= 0)
        throw InputError("seam-exact options: bending >= 0, max_iterations > 0");
    SeamProblem problem(tile, fabric, {options.bending, options.keep_area});
    SeamNewton newton(problem);
    const SeamSolution exact = solve(tile, fabric, problem, newton, options);
    Flattening result;
    result.positions = Eigen::Map<const Points2>(exact.u.data(), exact.u.size() / 2, 2);
    result.summary = exact.summary;
    result.certificate = {exact.force_residual, exact.length_residual, exact.strict_minimum};
    result.seam_tension = exact.lambda;
    result.edges_on_curve = true;
    align_with_grain(tile, result.positions);
    if (options.keep_area) result.note = price_of_area(tile, fabric, options, result.positions);
    return result;
}

}  // namespace ripstop
