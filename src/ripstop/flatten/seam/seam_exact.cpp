#include "ripstop/flatten/seam/seam_exact.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "ripstop/base/error.h"
#include "ripstop/base/text/number_text.h"
#include "ripstop/base/text/units.h"
#include "ripstop/flatten/map/boundary_first.h"
#include "ripstop/flatten/seam/coarse_start.h"
#include "ripstop/flatten/seam/seam_saddle.h"
#include "ripstop/flatten/tools/grain.h"
#include "ripstop/mesh/change/flips.h"
#include "ripstop/tile/targets.h"

namespace ripstop {
namespace {

constexpr int coarse_start_from =
    5'000;                             ///< triangles: for smaller tiles the coarse solve would cost as much as it saves
constexpr int direct_iterations = 20;  ///< after a start with exact boundary lengths; if more are needed, continuation
                                       ///< in the edge lengths works better

bool without_flips(const Tile& tile, const Flattening& flat) {
    return flat.summary.usable() && count_flipped(tile.mesh.triangles, flat.positions) == 0;
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

/// The increase of the thread strain due to keeping the area, compared with the same flattening without it.
std::string price_of_area(const Tile& tile, const Fabric& fabric, SeamExactOptions options, const Points2& positions) {
    options.keep_area = false;
    const Flattening plain = flatten_seam_exact(tile, fabric, options);
    return "keeping the area raises the largest thread strain from " +
           format_fixed(largest_thread_strain(tile, plain.positions) / percent, 3) + " to " +
           format_fixed(largest_thread_strain(tile, positions) / percent, 3) + " %";
}

/// Newton directly from a start with nearly correct edges; empty if that flips triangles.
std::optional<SeamSolution> from_boundary(const Tile& tile, const Fabric& fabric, SeamNewton& newton) {
    const Flattening flat = flatten_boundary_first(tile);
    if (!without_flips(tile, flat)) return std::nullopt;
    const bool large = tile.mesh.triangle_count() >= coarse_start_from;
    const Points2 start = large ? coarse_solution(tile, fabric, flat.positions) : flat.positions;
    return newton.minimize(Eigen::Map<const Eigen::VectorXd>(start.data(), start.size()),
                           {.max_iterations = direct_iterations});
}

/// Newton from the cloth's rest state with free edges.
SeamSolution from_rest(const Tile& tile, SeamProblem& problem, SeamNewton& newton, const SeamExactOptions& options) {
    const SeamNewtonOptions free{
        .hold_edges = false, .max_iterations = options.max_iterations, .force_tolerance = 1e-3};
    const SeamSolution loose = newton.minimize(seam_start(tile, options.start), free);
    const SeamNewtonOptions held{.max_iterations = options.max_iterations};
    const double outline = problem.lengths().sum();
    const bool too_much_area =
        options.keep_area && outline * outline < 4 * std::numbers::pi * problem.size() * problem.size();
    SeamSolution exact = too_much_area ? newton.minimize(loose.u, held) : hold_lengths(problem, newton, loose.u, held);
    exact = leave_saddles(problem, newton, exact, held);
    if (too_much_area && exact.summary.termination != Termination::converged)
        exact.summary.reason = "no outline of this length encloses the whole area";
    count_also(loose.summary, exact.summary);
    return exact;
}

SeamSolution solve(const Tile& tile, const Fabric& fabric, SeamProblem& problem, SeamNewton& newton,
                   const SeamExactOptions& options) {
    SolveSummary spent;
    if (options.start == SeamStart::boundary_first) {
        std::optional<SeamSolution> exact = from_boundary(tile, fabric, newton);
        if (exact) exact = leave_saddles(problem, newton, *exact);
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
