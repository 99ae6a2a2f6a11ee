#include "ripstop/flatten/seam_exact.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ripstop/base/error.h"
#include "ripstop/base/number_text.h"
#include "ripstop/base/units.h"
#include "ripstop/flatten/grain.h"

namespace ripstop {
namespace {

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

}  // namespace

Flattening flatten_seam_exact(const Tile& tile, const Fabric& fabric, const SeamExactOptions& options) {
    if (!(options.bending >= 0) || options.max_iterations <= 0)
        throw InputError("seam-exact options: bending >= 0, max_iterations > 0");
    SeamProblem problem(tile, fabric, {options.bending, options.keep_area});
    SeamNewton newton(problem);
    const SeamNewtonOptions free{
        .hold_edges = false, .max_iterations = options.max_iterations, .force_tolerance = 1e-3};
    const SeamSolution loose = newton.minimize(seam_start(tile, options.start), free);
    const SeamNewtonOptions held{.max_iterations = options.max_iterations};
    const double outline = problem.lengths().sum();
    const bool too_much_area =
        options.keep_area && outline * outline < 4 * std::numbers::pi * problem.size() * problem.size();
    SeamSolution exact =
        too_much_area ? newton.minimize(loose.u, held) : hold_lengths(problem, newton, loose.u, held);
    if (too_much_area && exact.summary.termination != Termination::converged)
        exact.summary.reason = "no outline of this length encloses the whole area";
    Flattening result;
    result.positions = Eigen::Map<const Points2>(exact.u.data(), exact.u.size() / 2, 2);
    result.summary = exact.summary;
    result.summary.iterations += loose.summary.iterations;
    result.summary.factorizations += loose.summary.factorizations;
    result.certificate = {exact.force_residual, exact.length_residual, exact.strict_minimum};
    result.seam_tension = exact.lambda;
    align_with_grain(tile, result.positions);
    if (options.keep_area) result.note = price_of_area(tile, fabric, options, result.positions);
    return result;
}

}  // namespace ripstop
