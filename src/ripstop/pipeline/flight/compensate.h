#pragma once

#include <string>
#include <vector>

#include "ripstop/model/flight/flight.h"
#include "ripstop/model/tile/envelope.h"
#include "ripstop/pipeline/flatten/flatten_envelope.h"
#include "ripstop/pipeline/flight/inflate_plan.h"

namespace ripstop {

/// Options of `compensate`: flattening, inflation, correction, number of rounds.
struct CompensateOptions {
    FlattenOptions flatten = {};
    InflatePlanOptions inflate = {};
    TapedSeams tapes = TapedSeams::by_type;
    int elastic_steps = 2;         ///< rounds that correct the patterns for the strain in flight
    int displacements = 8;         ///< maximum number of later rounds that move the target against the deviation
    double relaxation = 0.7;       ///< share of the deviation corrected in a round; halved if a round makes it worse
    bool find_sensitivity = true;  ///< also measure the sensitivity of the result (`measure_sensitivity`)
    double smoothing =
        0.01;  ///< share of the drawn height: narrower changes of the deviation are not cut into the cloth
    Progress progress = {};
};

/// Flattens, inflates and corrects the patterns round by round [STBG14, without the derivative]:
///
///     elastic:       cuts every triangle so that it has its drawn shape under the stress in flight: E* = C^-1 S, with
///                    S the relaxed stress, so no wrinkle is cut into the cloth;
///                    tapes are shortened by 1 / sqrt(1 + 2 N / EA)
///     displacement:  moves the target against the remaining deviation, X' <- X' - w (x - X), and cuts the metric of
///                    X'; x - X is smoothed, because a kink cut into the cloth is a strain in it
///
/// Both sides of a seam are cut to the same length: at each place, the mean of what the two sides ask for. The round
/// with the least deviation is kept: the larger of `Deviation::moved_rms` and a third of `Deviation::moved_max`. The
/// rounds end after two without an improvement.
///
/// Compensation for shrinkage and take-up (`Compensation::warp`, `weft`, `chains`) is added last. The simulation leaves
/// it out, because it describes the cloth after its first flights. Each round costs one flattening and one inflation.
///
/// The returned plan has the `tape_factors` to cut and, as `inflated`, the state before shrinkage with its causes,
/// rounds and sensitivity.
CutPlan compensate(const Envelope& envelope, const CompensateOptions& options);

/// Inflates the same plan with cloth 20 % stiffer and softer, shear stiffness doubled and halved, tapes 1 % longer and
/// shorter, and gas 20 degrees hotter and colder. Tapes and gas are varied only if the plan has them. Costs one
/// inflation for each variation.
std::vector<Sensitivity> measure_sensitivity(const CutPlan& plan, const InflatePlanOptions& options);

}  // namespace ripstop
