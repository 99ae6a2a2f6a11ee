#include "ripstop/pipeline/inflate_plan.h"

#include <chrono>
#include <cmath>

#include "ripstop/pipeline/find_symmetry.h"

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

constexpr double stiffer = 100;  // what is left of the deviation then is the shape's own

}  // namespace

Inflated inflate_plan(const CutPlan& plan, const InflatePlanOptions& options) {
    const auto begun = std::chrono::steady_clock::now();
    InflateOptions inflating;
    inflating.load = options.load;
    inflating.threads = options.threads;
    inflating.sewing.rigging = options.rigging;
    if (options.use_symmetry) inflating.sewing.symmetry = find_symmetry(plan);
    inflating.progress = part_of(options.progress, 0, options.find_causes ? 0.4 : 1);
    Inflated inflated = inflate(plan, inflating);
    if (options.find_causes) {
        std::vector<Points3> drawn;
        for (const FlatTile& tile : plan.tiles) drawn.push_back(tile.tile.mesh.positions);
        inflating.start = positions_of(inflated);
        inflating.sewing.rest = RestState::as_wanted;
        inflating.progress = part_of(options.progress, 0.4, 0.7);
        const Inflated wanted = inflate(plan, inflating);
        inflating.start.clear();
        inflating.sewing.rest = RestState::as_drawn;
        inflating.sewing.stiffer = stiffer;
        inflating.progress = part_of(options.progress, 0.7, 1);
        const Inflated stiff = inflate(plan, inflating);
        if (wanted.summary.termination == Termination::converged && stiff.summary.usable())
            inflated.causes = Causes{apart(positions_of(stiff), drawn), apart(positions_of(wanted), positions_of(stiff)),
                                     apart(positions_of(inflated), positions_of(wanted))};
    }
    inflated.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    return inflated;
}

}  // namespace ripstop
