#include "ripstop/pipeline/flight/compensate.h"

#include <fmt/format.h>

#include <algorithm>

#include "ripstop/pipeline/flight/smooth_displacement.h"
#include "ripstop/pipeline/flight/tape_seams.h"
#include "ripstop/pipeline/flight/wanted_cloth.h"

namespace ripstop {
namespace {

/// Removes the compensation that has nothing to do with flight (shrinkage, take-up) until the end.
std::vector<Compensation> take_shrinkage(Envelope& envelope) {
    std::vector<Compensation> taken;
    for (Tile& tile : envelope.tiles) {
        taken.push_back(tile.compensation);
        tile.compensation = {};
    }
    return taken;
}

void give_shrinkage(const std::vector<Compensation>& taken, Envelope& envelope) {
    for (std::size_t i = 0; i < envelope.tiles.size(); ++i) {
        envelope.tiles[i].compensation.warp = taken[i].warp;
        envelope.tiles[i].compensation.weft = taken[i].weft;
        envelope.tiles[i].compensation.chains = taken[i].chains;
    }
}

/// The score of a round. The limits are a thousandth of the height overall and three thousandths in places.
double score(const Inflated& inflated) {
    return std::max(inflated.off.moved_rms, inflated.off.moved_max / 3);
}

/// Runs the rounds and keeps the best one.
class Correction {
  public:
    Correction(Envelope envelope, const CompensateOptions& options)
        : envelope_(std::move(envelope)), options_(options), total_(4 + options.elastic_steps + options.displacements) {
        options_.inflate.find_causes = false;
    }

    /// Cuts and inflates the wanted cloth. Returns whether the result is the best so far.
    bool round(const std::string& step, double relaxation, const WantedCloth& wanted) {
        compensate_tiles(wanted, envelope_);
        FlattenOptions flattening = options_.flatten;
        flattening.progress = part(step, 0, 0.3);
        last_ = flatten_envelope(envelope_, flattening);
        tape_seams(last_, options_.tapes);
        last_.tape_factors = tape_factors(wanted, envelope_);
        last_.is_compensated = !rounds_.empty();
        InflatePlanOptions inflating = options_.inflate;
        inflating.progress = part(step, 0.3, 1);
        last_.inflated = inflate_plan(last_, inflating);
        const auto is_at_rest = [](const CutPlan& plan) {
            return plan.inflated->summary.termination == Termination::converged;
        };
        const bool is_best =
            rounds_.empty() ||
            (is_at_rest(last_) && (!is_at_rest(best_) || score(*last_.inflated) < score(*best_.inflated)));
        rounds_.push_back({is_at_rest(last_) ? step : step + ", not at rest", last_.inflated->off,
                           last_.inflated->height, last_.inflated->volume, relaxation});
        if (!is_best) return false;
        best_ = last_;
        best_wanted_ = wanted;
        for (CompensationRound& each : rounds_) each.is_best = &each == &rounds_.back();
        return true;
    }

    const CutPlan& last() const { return last_; }
    const CutPlan& best() const { return best_; }
    const WantedCloth& best_wanted() const { return best_wanted_; }
    const std::vector<CompensationRound>& rounds() const { return rounds_; }
    Envelope& envelope() { return envelope_; }

    Progress part(const std::string& step, double from, double to) const {
        if (!options_.progress) return {};
        const double done = static_cast<double>(rounds_.size());
        return [this, step, from, to, done](double fraction, const std::string& what) {
            options_.progress(std::min(1.0, (done + from + (to - from) * fraction) / total_),
                              fmt::format("{}: {}", step, what));
        };
    }

  private:
    Envelope envelope_;
    CompensateOptions options_;
    int total_;
    CutPlan best_, last_;
    WantedCloth best_wanted_;
    std::vector<CompensationRound> rounds_;
};

/// X' - w (x - X): moves the target against the smooth part of the deviation.
void displace(WantedCloth& wanted, const CutPlan& plan, const CompensateOptions& options, double share) {
    std::vector<Points3> off;
    for (std::size_t i = 0; i < plan.tiles.size(); ++i)
        off.push_back(plan.inflated->tiles[i].positions - plan.tiles[i].tile.mesh.positions);
    const double length = options.smoothing * plan.inflated->drawn_height;
    const std::vector<Points3> smooth = smooth_displacement(plan, options.inflate.rigging, off, length);
    for (std::size_t i = 0; i < plan.tiles.size(); ++i) wanted.target[i] -= share * smooth[i];
}

}  // namespace

CutPlan compensate(const Envelope& envelope, const CompensateOptions& options) {
    Envelope bare = envelope;
    const std::vector<Compensation> shrinkage = take_shrinkage(bare);
    WantedCloth wanted = drawn_cloth(bare);
    Correction correction(std::move(bare), options);
    correction.round("as drawn", 0, wanted);
    for (int step = 0; step < options.elastic_steps; ++step) {
        wanted.strain = elastic_strain(correction.last(), *correction.last().inflated);
        wanted.tape_strain = tape_strains(correction.last());
        if (!correction.round("elastic", 0, wanted)) break;
    }
    double share = options.relaxation;
    for (int step = 0, idle = 0; step < options.displacements && idle < 2; ++step) {
        wanted = correction.best_wanted();
        const double before = score(*correction.best().inflated);
        displace(wanted, correction.best(), options, share);
        const bool is_better = correction.round("displacement", share, wanted);
        if (!is_better) share *= 0.5;
        idle = is_better && score(*correction.best().inflated) < 0.98 * before ? 0 : idle + 1;
    }

    CutPlan result = correction.best();
    InflatePlanOptions judging = options.inflate;
    judging.progress = correction.part("what is cut", 0, 1);
    result.inflated = inflate_plan(result, judging);
    result.rounds = correction.rounds();
    if (options.find_sensitivity) {
        judging.progress = correction.part("other cloth, tapes and air", 1, 3);
        result.inflated->sensitivity = measure_sensitivity(result, judging);
    }
    if (std::none_of(shrinkage.begin(), shrinkage.end(), [](const Compensation& each) { return each.any(); }))
        return result;
    compensate_tiles(correction.best_wanted(), correction.envelope());
    give_shrinkage(shrinkage, correction.envelope());
    FlattenOptions flattening = options.flatten;
    flattening.progress = {};
    CutPlan longer = flatten_envelope(correction.envelope(), flattening);
    tape_seams(longer, options.tapes);
    longer.tape_factors = result.tape_factors;
    longer.is_compensated = result.is_compensated;
    longer.inflated = std::move(result.inflated);
    return longer;
}

std::vector<Sensitivity> measure_sensitivity(const CutPlan& plan, const InflatePlanOptions& options) {
    constexpr int most_trials = 8;
    std::vector<Sensitivity> found;
    const auto try_one = [&](const std::string& what, const CutPlan& changed, const InflatePlanOptions& loaded) {
        InflatePlanOptions inflating = loaded;
        inflating.find_causes = false;
        const double begin = static_cast<double>(found.size()) / most_trials;
        inflating.progress = {};
        if (options.progress)
            inflating.progress = [&, begin](double fraction, const std::string& step) {
                options.progress(begin + fraction / most_trials, what + ": " + step);
            };
        const Inflated inflated = inflate_plan(changed, inflating);
        const bool rests = inflated.summary.termination == Termination::converged;
        found.push_back({rests ? what : what + ", not at rest", inflated.off, inflated.height, inflated.volume});
    };
    const auto with_cloth = [&](double threads, double shear) {
        CutPlan changed = plan;
        const auto change = [&](Fabric& fabric) {
            fabric.warp_stiffness *= threads;
            fabric.weft_stiffness *= threads;
            fabric.shear_stiffness *= shear;
        };
        change(changed.fabric);
        for (FlatTile& tile : changed.tiles)
            if (tile.tile.fabric) change(*tile.tile.fabric);
        return changed;
    };
    try_one("cloth 20 % stiffer", with_cloth(1.2, 1.2), options);
    try_one("cloth 20 % softer", with_cloth(0.8, 0.8), options);
    try_one("shear twice as stiff", with_cloth(1, 2), options);
    try_one("shear half as stiff", with_cloth(1, 0.5), options);
    const bool has_tapes =
        std::any_of(plan.seams.begin(), plan.seams.end(), [](const Seam& seam) { return seam.has_tape(); });
    for (const double longer : {0.01, -0.01}) {
        if (!has_tapes) break;
        CutPlan changed = plan;
        if (changed.tape_factors.empty()) changed.tape_factors.assign(plan.seams.size(), 1);
        for (double& factor : changed.tape_factors) factor *= 1 + longer;
        try_one(longer > 0 ? "load tapes 1 % longer" : "load tapes 1 % shorter", changed, options);
    }
    for (const double hotter : {20.0, -20.0}) {
        InflatePlanOptions changed = options;
        changed.load.air.inside += hotter;
        if (changed.load.air.inside <= changed.load.air.outside || changed.load.air.inside > hottest) continue;
        try_one(hotter > 0 ? "inside 20 degrees hotter" : "inside 20 degrees colder", plan, changed);
    }
    return found;
}

}  // namespace ripstop
