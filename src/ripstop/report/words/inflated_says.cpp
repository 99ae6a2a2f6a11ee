#include "ripstop/report/words/inflated_says.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ripstop/base/text/units.h"
#include "ripstop/report/figures/figures.h"

namespace ripstop {
namespace {

using Sentences = std::vector<std::string>;

std::string millimetres_text(double length) {
    return shown(length / millimetre, std::abs(length) < 9.95 * millimetre ? 1 : 0) + " mm";
}

void say_rest(const Inflated& inflated, Sentences& says) {
    if (inflated.summary.termination != Termination::converged)
        says.push_back("The inflation did not come to rest (" + inflated.summary.text() +
                       "): do not trust what follows.");
    else if (inflated.force_residual > 1e-3)
        says.push_back("It is at rest except for wrinkles that come and go: " + inflated.summary.reason + ".");
    if (inflated.summary.termination == Termination::converged && !inflated.is_stable)
        says.push_back("The shape is not stable: a small push moves it to another one.");
    constexpr double unbalanced = 0.01;
    if (std::abs(inflated.imbalance) > unbalanced)
        says.push_back("Lift, weight and holding forces differ by " + shown(inflated.imbalance / percent, 1) +
                       " %: finer triangles would make the figures more certain.");
}

/// `isotropic` is meant for comparing methods, and is the default of `flatten`.
void say_cloth(const CutPlan& plan, Sentences& says) {
    const std::vector<Fabric> fabrics = plan.fabrics();
    if (std::any_of(fabrics.begin(), fabrics.end(), [](const Fabric& fabric) { return fabric.name == "isotropic"; }))
        says.push_back(
            "No fabric was given: this is \"isotropic\", a placeholder many times softer than real cloth. Flatten with "
            "--fabric, such as nylon, before you rely on these figures.");
}

void say_deviation(const Inflated& inflated, Sentences& says) {
    const double limit = deviation_limit(inflated), rms = inflated.off.rms, most = std::abs(inflated.off.max);
    const std::string share =
                          shown(deviation_share / percent, 1) + " % of its height (" + millimetres_text(limit) + ")",
                      worst = millimetres_text(most) + (inflated.off.max < 0 ? " inside it" : " outside it");
    if (rms > limit)
        says.push_back("Inflated, it is more than " + share + " off the drawn shape: " + millimetres_text(rms) +
                       " (root mean square), at most " + worst + ".");
    else if (most > limit)
        says.push_back("Inflated, it is within " + share + " of the drawn shape overall, " + millimetres_text(rms) +
                       " off (root mean square), but up to " + worst + " in places.");
    else
        says.push_back("Inflated, it is everywhere within " + share + " of the drawn shape: " + millimetres_text(rms) +
                       " off (root mean square), at most " + worst + ".");
}

void say_causes(const CutPlan& plan, Sentences& says) {
    const Inflated& inflated = *plan.inflated;
    const double limit = deviation_limit(inflated);
    if (inflated.causes) {
        const Causes& causes = *inflated.causes;
        const std::string bare = "if cut without error from cloth that does not stretch, it would be " +
                                 millimetres_text(causes.shape) + " off.";
        if (!(causes.shape > limit))
            says.push_back("Gas pressure can hold this shape: " + bare);
        else if (is_corrected(plan) && inflated.off.moved_rms <= limit)
            says.push_back("As drawn, gas pressure could not hold this shape: even " + bare +
                           " The corrected patterns make up for it.");
        else
            says.push_back("This shape cannot be held by gas pressure: even " + bare);
        if (is_corrected(plan) && inflated.off.moved_rms <= limit)
            ;  // the pieces were not meant to match the drawing
        else if (!std::isfinite(causes.patterns))
            says.push_back("The effect of the patterns is not known: the shape they were corrected for is not stored.");
        else
            says.push_back(std::string("The patterns are ") + (causes.patterns > limit ? "wrong" : "right") +
                           ": their errors move it by " + millimetres_text(causes.patterns) + ".");
        if (!is_corrected(plan))
            says.push_back(causes.stretch > limit ? "The stretch of the cloth and the paths of the tapes move it by " +
                                                        millimetres_text(causes.stretch) + ": cut with --compensate."
                                                  : "The stretch of cloth and tapes moves it by " +
                                                        millimetres_text(causes.stretch) + ".");
    }
    const auto best =
        std::find_if(plan.rounds.begin(), plan.rounds.end(), [](const auto& each) { return each.is_best; });
    if (plan.rounds.size() > 1 && best != plan.rounds.end())
        says.push_back("Correcting the patterns brought it from " +
                       millimetres_text(plan.rounds.front().off.moved_rms) + " to " +
                       millimetres_text(best->off.moved_rms) + " from the drawn places (root mean square).");
}

void say_lift(const Inflated& inflated, Sentences& says) {
    const Air& air = inflated.load.air;
    says.push_back(fmt::format(
        "At {} C inside and {} C outside, at an altitude of {} m, it lifts {} kg ({} N) in addition to its own weight.",
        shown(air.inside, 0), shown(air.outside, 0), shown(air.altitude, 0), shown(inflated.lift / gravity, 0),
        shown(inflated.lift, 0)));
}

void say_weakness(const Inflated& inflated, Sentences& says) {
    for (const SafetyFactor& each : inflated.safety)
        if (!each.ok())
            says.push_back(fmt::format("Too weak: {}, factor {}, required {:g} ({}).", each.part, shown(each.factor, 2),
                                       each.required, each.where));
}

void say_strength(const Inflated& inflated, Sentences& says) {
    if (inflated.safety.empty() || !inflated.is_safe()) return;
    const SafetyFactor& least = *std::min_element(
        inflated.safety.begin(), inflated.safety.end(),
        [](const SafetyFactor& a, const SafetyFactor& b) { return a.factor / a.required < b.factor / b.required; });
    says.push_back(fmt::format("Strong enough; smallest margin: {}, factor {}, required {:g} ({}).", least.part,
                               shown(least.factor, 2), least.required, least.where));
}

/// States shrinkage in each direction and take-up separately, with the number of tiles that have them.
void say_compensation(const CutPlan& plan, Sentences& says) {
    const auto say = [&](const std::string& what, const auto& value_of) {
        double least = 0, most = 0;
        int count = 0;
        for (const FlatTile& tile : plan.tiles) {
            const double value = value_of(tile.tile.compensation);
            if (value == 0) continue;
            least = count == 0 ? value : std::min(least, value);
            most = count == 0 ? value : std::max(most, value);
            ++count;
        }
        if (count == 0) return;
        const std::string range =
            least == most ? shown(least / percent, 2) : shown(least / percent, 2) + " to " + shown(most / percent, 2);
        says.push_back(fmt::format("{} of {} tiles {} cut longer for {}: {} %.", count, plan.tiles.size(),
                                   count == 1 ? "is" : "are", what, range));
    };
    say("shrinkage along the warp", [](const Compensation& longer) { return longer.warp; });
    say("shrinkage along the weft", [](const Compensation& longer) { return longer.weft; });
    say("take-up of the seams", [](const Compensation& longer) {
        return longer.chains.empty() ? 0.0 : *std::max_element(longer.chains.begin(), longer.chains.end());
    });
}

void say_wrinkles(const Inflated& inflated, Sentences& says) {
    constexpr double worth_saying = 0.005;
    if (inflated.wrinkled < worth_saying && inflated.slack < worth_saying) return;
    says.push_back(fmt::format("{} % of the cloth is wrinkled, {} % is slack.", shown(inflated.wrinkled / percent, 1),
                               shown(inflated.slack / percent, 1)));
}

}  // namespace

double deviation_limit(const Inflated& inflated) {
    return deviation_share * inflated.drawn_height;
}

bool flies_as_drawn(const CutPlan& plan) {
    const Inflated& inflated = *plan.inflated;
    return inflated.summary.termination == Termination::converged && inflated.off.rms <= deviation_limit(inflated) &&
           inflated.is_safe();
}

bool is_corrected(const CutPlan& plan) {
    return plan.is_compensated || (plan.rounds.size() > 1);
}

Sentences inflated_says(const CutPlan& plan) {
    const Inflated& inflated = *plan.inflated;
    if (!inflated.summary.usable()) return {"The inflation failed: " + inflated.summary.reason + "."};
    Sentences says;
    say_cloth(plan, says);
    if (!inflated.stands()) {
        says.push_back(fmt::format(
            "It does not stand: at {} C inside and {} C outside, at an altitude of {} m, the gas does not carry it{}.",
            shown(inflated.load.air.inside, 0), shown(inflated.load.air.outside, 0),
            shown(inflated.load.air.altitude, 0),
            inflated.volume > 0.5 * inflated.drawn_volume
                ? ", " + shown(-inflated.lift / gravity, 1) + " kg are missing"
                : ", and it falls in on itself"));
        return says;
    }
    say_rest(inflated, says);
    say_deviation(inflated, says);
    say_weakness(inflated, says);
    say_causes(plan, says);
    say_strength(inflated, says);
    say_lift(inflated, says);
    say_wrinkles(inflated, says);
    say_compensation(plan, says);
    return says;
}

}  // namespace ripstop
