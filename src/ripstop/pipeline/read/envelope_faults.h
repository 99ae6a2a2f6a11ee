#pragma once

#include <string>
#include <vector>

#include "ripstop/model/plan/cut_plan.h"
#include "ripstop/model/plan/envelope_check.h"
#include "ripstop/pipeline/read/read_envelope.h"

namespace ripstop {

/// How `judge_input` judges.
struct JudgeOptions {
    double seam_tolerance = 0.5 * millimetre;  ///< as in `ReadOptions` [m]
    bool is_whole = true;                      ///< false: only some tiles were read (`ReadOptions::only`)
    std::vector<std::string> accept = {};      ///< codes of issues that are meant (`acceptable_issues`)
};

/// What is wrong with an envelope that was read: the one judgement of `check` and `flatten`, which leaves to each only
/// what it alone knows of the seams (`add_seam_doubts`, `judge_seams`).
///
/// `check_envelope` on the tiles with the meshes they were drawn with (`EnvelopeInput::drawn`), so that remeshing
/// neither makes nor mends a fault; before its issues those of the file. Of some tiles alone only the unit is judged,
/// and the file: the tiles left out may explain anything else. Last, what is meant is accepted (`accept_issues`).
EnvelopeCheck judge_input(const EnvelopeInput& input, const JudgeOptions& options);

/// Takes the issues of these codes for meant: each is a note from now on, `EnvelopeCheck::meant`. Codes that are none
/// of `acceptable_issues` change nothing.
void accept_issues(EnvelopeCheck& check, const std::vector<std::string>& codes);

/// Takes what is wrong with the envelope as it was given into a plan's findings, under the issue's own code, with the
/// names of its tiles. Values in mm, for `scaled` the ratio; the limit is the issue's own, else the seam tolerance, for
/// `scaled` 1; of what is only counted, as a missing tile, one too many. What is meant goes into the plan's remarks.
/// `uncertain` is left out: `judge_seams` has judged the seams of the meshes that were flattened.
void add_faults(CutPlan& plan, const EnvelopeCheck& check);

}  // namespace ripstop
