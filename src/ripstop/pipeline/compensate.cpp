#include "ripstop/pipeline/compensate.h"

#include <fmt/format.h>

#include <algorithm>

#include "ripstop/pipeline/tape_meridians.h"
#include "ripstop/pipeline/wanted_cloth.h"

namespace ripstop {
namespace {

/// What the cloth is cut longer for beside the flight, taken off until the end.
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

/// One round after the other, and the best so far.
class Correction {
  public:
    Correction(Envelope envelope, const CompensateOptions& options)
        : envelope_(std::move(envelope)), options_(options), rounds_(1 + options.elastic_steps + options.displacements) {
        options_.inflate.find_causes = false;
        best_.inflated.off.moved_rms = 1e300;
    }

    /// Cuts and inflates what is wanted. Is it the best so far?
    bool round(const std::string& step, double relaxation, const WantedCloth& wanted) {
        compensate_tiles(wanted, envelope_);
        FlattenOptions flattening = options_.flatten;
        flattening.progress = part(step, 0, 0.3);
        CutPlan plan = flatten_envelope(envelope_, flattening);
        if (options_.tape_meridians) tape_meridians(plan);
        InflatePlanOptions inflating = options_.inflate;
        inflating.tape_factors = tape_factors(wanted, envelope_);
        inflating.progress = part(step, 0.3, 1);
        Inflated inflated = inflate_plan(plan, inflating);
        const bool is_best = inflated.summary.termination == Termination::converged &&
                             inflated.off.moved_rms < best_.inflated.off.moved_rms;
        best_.rounds.push_back({step, inflated.off, inflated.height, inflated.volume, relaxation, false});
        last_ = {plan, inflated, inflating.tape_factors, {}};
        if (!is_best && !best_.plan.tiles.empty()) return false;
        best_.plan = std::move(plan);
        best_.inflated = std::move(inflated);
        best_.tape_factors = std::move(inflating.tape_factors);
        best_wanted_ = wanted;
        for (CompensationRound& each : best_.rounds) each.is_best = false;
        best_.rounds.back().is_best = true;
        return is_best;
    }

    const CompensatedPlan& last() const { return last_; }
    const CompensatedPlan& best() const { return best_; }
    const WantedCloth& best_wanted() const { return best_wanted_; }
    Envelope& envelope() { return envelope_; }

  private:
    Progress part(const std::string& step, double from, double to) const {
        if (!options_.progress) return {};
        const double done = static_cast<double>(best_.rounds.size());
        return [this, step, from, to, done](double fraction, const std::string& what) {
            options_.progress(std::min(1.0, (done + from + (to - from) * fraction) / rounds_),
                              fmt::format("{} {}: {}", step, best_.rounds.size(), what));
        };
    }

    Envelope envelope_;
    CompensateOptions options_;
    int rounds_;
    CompensatedPlan best_, last_;
    WantedCloth best_wanted_;
};

/// X' - w (x - X): the target moved against what the inflated shape is off.
void displace(WantedCloth& wanted, const CutPlan& plan, const Inflated& inflated, double share) {
    for (std::size_t i = 0; i < plan.tiles.size(); ++i)
        wanted.target[i] -= share * (inflated.tiles[i].positions - plan.tiles[i].tile.mesh.positions);
}

}  // namespace

CompensatedPlan compensate(const Envelope& envelope, const CompensateOptions& options) {
    Envelope bare = envelope;
    const std::vector<Compensation> shrinkage = take_shrinkage(bare);
    WantedCloth wanted = drawn_cloth(bare);
    Correction correction(std::move(bare), options);
    correction.round("as drawn", 0, wanted);
    for (int step = 0; step < options.elastic_steps; ++step) {
        const CompensatedPlan& last = correction.last();
        wanted.strain = elastic_strain(last.plan, last.inflated);
        wanted.tape_strain = tape_strains(last.plan, last.inflated, last.tape_factors);
        if (!correction.round("elastic", 0, wanted)) break;
    }
    double share = options.relaxation;
    for (int step = 0, idle = 0; step < options.displacements && idle < 2; ++step) {
        wanted = correction.best_wanted();
        const double before = correction.best().inflated.off.moved_rms;
        displace(wanted, correction.best().plan, correction.best().inflated, share);
        const bool is_better = correction.round("displacement", share, wanted);
        if (!is_better) share *= 0.5;
        idle = is_better && correction.best().inflated.off.moved_rms < 0.98 * before ? 0 : idle + 1;
    }

    CompensatedPlan result = correction.best();
    if (std::none_of(shrinkage.begin(), shrinkage.end(), [](const Compensation& each) { return each.any(); }))
        return result;
    compensate_tiles(correction.best_wanted(), correction.envelope());
    give_shrinkage(shrinkage, correction.envelope());
    FlattenOptions flattening = options.flatten;
    flattening.progress = {};
    result.plan = flatten_envelope(correction.envelope(), flattening);
    if (options.tape_meridians) tape_meridians(result.plan);
    return result;
}

std::vector<Sensitivity> measure_sensitivity(const CutPlan& plan, const InflatePlanOptions& options) {
    std::vector<Sensitivity> found;
    const auto try_one = [&](const std::string& what, const CutPlan& changed, const InflatePlanOptions& loaded) {
        InflatePlanOptions inflating = loaded;
        inflating.find_causes = false;
        inflating.progress = {};
        const Inflated inflated = inflate_plan(changed, inflating);
        found.push_back({what, inflated.off, inflated.height, inflated.volume});
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
        std::any_of(plan.seams.begin(), plan.seams.end(), [](const Seam& seam) { return seam.type.tape; });
    for (const double longer : {0.01, -0.01}) {
        if (!has_tapes) break;
        InflatePlanOptions changed = options;
        if (changed.tape_factors.empty()) changed.tape_factors.assign(plan.seams.size(), 1);
        for (double& factor : changed.tape_factors) factor *= 1 + longer;
        try_one(longer > 0 ? "load tapes 1 % longer" : "load tapes 1 % shorter", plan, changed);
    }
    for (const double hotter : {20.0, -20.0}) {
        InflatePlanOptions changed = options;
        changed.load.air.inside += hotter;
        if (changed.load.air.inside <= changed.load.air.outside) continue;
        try_one(hotter > 0 ? "inside 20 degrees hotter" : "inside 20 degrees colder", plan, changed);
    }
    return found;
}

}  // namespace ripstop
