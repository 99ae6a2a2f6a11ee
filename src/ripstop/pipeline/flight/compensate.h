#pragma once

#include <string>
#include <vector>

#include "ripstop/model/flight/flight.h"
#include "ripstop/model/tile/envelope.h"
#include "ripstop/pipeline/flatten/flatten_envelope.h"
#include "ripstop/pipeline/flight/inflate_plan.h"

namespace ripstop {

/// How `compensate` flattens, inflates and corrects, and how many rounds it takes.
struct CompensateOptions {
    FlattenOptions flatten = {};
    InflatePlanOptions inflate = {};
    TapedSeams tapes = TapedSeams::by_type;
    int elastic_steps = 2;         ///< rounds that cut the cloth for the strain it has in flight
    int displacements = 8;         ///< at most so many rounds after these that move the target against the deviation
    double relaxation = 0.7;       ///< by this share of the deviation; halved where a round makes it worse
    bool find_sensitivity = true;  ///< of the result (`measure_sensitivity`)
    double smoothing =
        0.01;  ///< share of the drawn height: narrower changes of the deviation are not cut into the cloth
    Progress progress = {};
};

/// Flattens, inflates and corrects the patterns, round by round [STBG14, without the derivative]:
///
///     elastic:       every triangle is cut so that it is as drawn under the stress it bears in flight: E* = C^-1 S,
///                    S the relaxed stress, so that no wrinkle is cut into the cloth;
///                    tapes are shorter by 1 / sqrt(1 + 2 N / EA)
///     displacement:  the target moves against the deviation that is left, X' <- X' - w (x - X), and the metric of X'
///                    is cut; x - X is smoothed, because a kink cut into the cloth is a strain in it
///
/// Both sides of a seam are cut alike: place by place, the length of the seam's curve is the mean of what the two sides
/// ask for. The round with the least deviation is kept, which is the larger of `Deviation::moved_rms` and a third of
/// `Deviation::moved_max`; the rounds end when two of them gain nothing.
///
/// What tiles are cut longer for shrinkage and take-up (`Compensation::warp`, `weft`, `chains`) is added last. The
/// simulation leaves it out, because it is of the cloth after its first flights. One flattening and one inflation a
/// round.
///
/// The plan has the `tape_factors` to cut and, as `inflated`, the state before shrinkage with its causes, rounds and
/// sensitivity.
CutPlan compensate(const Envelope& envelope, const CompensateOptions& options);

/// Inflates the same plan with cloth 20 % stiffer and softer, shear twice and half as stiff, tapes 1 % longer and
/// shorter, and gas 20 degrees hotter and colder. Tapes and gas are varied only if the plan has them. One inflation
/// each.
std::vector<Sensitivity> measure_sensitivity(const CutPlan& plan, const InflatePlanOptions& options);

}  // namespace ripstop
