#include "ripstop/pipeline/flight/inflate_plan.h"

#include <chrono>
#include <cmath>
#include <limits>

#include "ripstop/pipeline/flight/find_symmetry.h"

namespace ripstop {
namespace {

/// Root mean square distance between the vertices of two states [m].
double apart(const std::vector<Points3>& a, const std::vector<Points3>& b) {
    double sum = 0, count = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        sum += (a[i] - b[i]).squaredNorm();
        count += static_cast<double>(a[i].rows());
    }
    return std::sqrt(sum / count);
}

std::vector<Points3> positions_of(const Inflated& inflated) {
    std::vector<Points3> positions;
    for (const InflatedTile& tile : inflated.tiles) positions.push_back(tile.positions);
    return positions;
}

Progress part_of(const Progress& progress, double from, double to) {
    if (!progress) return {};
    return [=](double fraction, const std::string& what) { progress(from + (to - from) * fraction, what); };
}

/// Extrapolates to cloth that does not stretch, from the real positions and those with cloth `stiffer` times as stiff:
/// stretch is proportional to 1 / stiffness.
std::vector<Points3> unstretched(const std::vector<Points3>& real, const std::vector<Points3>& stiff, double stiffer) {
    std::vector<Points3> positions;
    for (std::size_t i = 0; i < real.size(); ++i) positions.push_back(stiff[i] + (stiff[i] - real[i]) / (stiffer - 1));
    return positions;
}

/// Inflates the plan twice more: with stiffer cloth as drawn, and with its own cloth cut without error. Empty if these
/// do not converge. If the plan is compensated for a strain that is not available, `patterns` is NaN and is counted in
/// `stretch`.
std::optional<Causes> find_causes(const CutPlan& plan, const Inflated& inflated, InflateOptions inflating,
                                  const Progress& progress) {
    const auto is_at_rest = [](const Inflated& each) { return each.summary.termination == Termination::converged; };
    if (!is_at_rest(inflated) || !inflated.stands()) return std::nullopt;
    std::vector<Points3> drawn;
    bool knows_strain = !plan.is_compensated;
    for (const FlatTile& tile : plan.tiles) {
        drawn.push_back(tile.tile.mesh.positions);
        knows_strain = knows_strain || tile.tile.compensation.strain.rows() > 0;
    }
    const std::vector<Points3> there = positions_of(inflated);
    std::vector<Points3> without_error = there;
    if (knows_strain) {
        inflating.start = there;
        inflating.sewing.rest = RestState::as_wanted;
        inflating.progress = part_of(progress, 0.4, 0.7);
        const Inflated wanted = inflate(plan, inflating);
        if (!is_at_rest(wanted)) return std::nullopt;
        without_error = positions_of(wanted);
    }
    inflating.start = without_error;
    inflating.sewing.rest = RestState::as_drawn;
    inflating.sewing.rigging.foreshortening = 0;
    inflating.progress = part_of(progress, 0.7, 1);
    std::vector<Points3> own;
    // Soft cloth strains too much for a linear extrapolation from two stiffnesses.
    for (double stiffer = 10; stiffer <= 1000; stiffer *= 10) {
        inflating.sewing.stiffer = stiffer;
        const Inflated stiff = inflate(plan, inflating);
        if (!is_at_rest(stiff)) return std::nullopt;
        const std::vector<Points3> there_stiff = positions_of(stiff);
        own = unstretched(inflating.start, there_stiff, 10);
        if (apart(inflating.start, there_stiff) < 0.01 * inflated.drawn_height) break;
        inflating.start = there_stiff;
    }
    return Causes{apart(own, drawn), apart(without_error, own),
                  knows_strain ? apart(there, without_error) : std::numeric_limits<double>::quiet_NaN()};
}

}  // namespace

Inflated inflate_plan(const CutPlan& plan, const InflatePlanOptions& options) {
    const auto begun = std::chrono::steady_clock::now();
    InflateOptions inflating;
    inflating.load = options.load;
    inflating.threads = options.threads;
    inflating.sewing.rigging = options.rigging;
    // Ties and diaphragms exist once, not once per sector.
    const bool repeats = options.rigging.ties.empty() && options.rigging.diaphragms.empty();
    if (options.use_symmetry && repeats) inflating.sewing.symmetry = find_symmetry(plan);
    inflating.progress = part_of(options.progress, 0, options.find_causes ? 0.4 : 1);
    Inflated inflated = inflate(plan, inflating);
    if (options.find_causes) inflated.causes = find_causes(plan, inflated, inflating, options.progress);
    inflated.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    return inflated;
}

}  // namespace ripstop
