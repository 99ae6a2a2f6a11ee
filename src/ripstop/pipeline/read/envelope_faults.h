#pragma once

#include <string>
#include <vector>

#include "ripstop/model/plan/cut_plan.h"
#include "ripstop/model/plan/envelope_check.h"
#include "ripstop/pipeline/read/read_envelope.h"

namespace ripstop {

/// Options of `judge_input`.
struct JudgeOptions {
    double seam_tolerance = 0.5 * millimetre;  ///< as in `ReadOptions` [m]
    bool is_whole = true;                      ///< false: only some tiles were read (`ReadOptions::only`)
    std::vector<std::string> accept = {};      ///< codes of accepted issues (`acceptable_issues`)
};

/// Judges an envelope that was read. `check` and `flatten` share this judgement; each adds only what it alone knows of
/// the seams (`add_seam_doubts`, `judge_seams`).
///
/// Returns the issues of the file, then those of `check_envelope` on the tiles with their drawn meshes
/// (`EnvelopeInput::drawn`), so remeshing neither makes nor mends a fault. If only some tiles were read, only the file
/// and the unit are judged, because the omitted tiles may explain everything else. Accepted issues are applied last
/// (`accept_issues`).
EnvelopeCheck judge_input(const EnvelopeInput& input, const JudgeOptions& options);

/// Accepts the issues with these codes: each becomes a note, `EnvelopeCheck::meant`. Codes that are not among
/// `acceptable_issues` have no effect.
void accept_issues(EnvelopeCheck& check, const std::vector<std::string>& codes);

/// Adds the faults of the input envelope to a plan's findings, under the issue's own code, with the names of its tiles.
/// Values are in mm; for `scaled`, the ratio. The limit is the issue's own, else the seam tolerance; for `scaled`, 1.
/// An issue that is only counted, such as a missing tile, has the value 1 and the limit 0. Accepted issues go into the
/// plan's remarks. `uncertain` is left out: `judge_seams` judges the seams of the meshes that were flattened.
void add_faults(CutPlan& plan, const EnvelopeCheck& check);

}  // namespace ripstop
