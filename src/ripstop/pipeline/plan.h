#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ripstop/base/progress.h"
#include "ripstop/model/flight/flight.h"
#include "ripstop/model/piece/pattern_piece.h"
#include "ripstop/model/plan/cut_plan.h"
#include "ripstop/pattern/piece/pieces.h"
#include "ripstop/pipeline/read/read_envelope.h"
#include "ripstop/plan_folder/directory.h"
#include "ripstop/plan_folder/unchanged.h"

/// The main job: from a drawn envelope to a plan, and from a plan to its folder and back.
namespace ripstop {

/// For which failing tiles additional seams are tried.
enum class ProposeScope {
    none,
    automatic,  ///< all tiles, unless they are of too many kinds (`ProposeLimits`)
    all
};

/// The options of `plan_envelope`. Options that are not set come from the project (`completed`).
struct Job {
    ReadOptions read = {.remesh = {.mode = RemeshMode::automatic}};
    std::string fabric_name = {};               ///< a preset or a file; empty: the project's, else isotropic
    std::optional<Fabric> fabric = {};          ///< replaces `fabric_name`
    std::optional<double> seam_tolerance = {};  ///< [m]; default: the project's, else that of `read`
    std::optional<Tolerances> tolerances = {};  ///< default: those of the fabric, as changed by the project
    std::vector<std::string> accept = {};       ///< codes of accepted issues, in addition to the project's
    std::string method = "seam-exact";          ///< as `FlattenOptions::method`
    bool compensate = false;                    ///< correct the patterns for the shape in flight (`compensate`)
    std::function<Flight(Flight)> flight = {};  ///< modifies the project's flight conditions; for `compensate`
    ProposeScope propose = ProposeScope::automatic;
    bool propose_merges = false;
    PieceOptions pieces = {};    ///< default revision: the start of the input's hash
    bool allowance_fit = false;  ///< as in `judge_cut_lines`
    int threads = 0;             ///< 0: one per core
};

/// Returns the job completed by its project, with its fabric and tolerances resolved. Settings of the job take
/// precedence. Throws InputError for an unknown fabric.
Job completed(Job job);

/// A step of the work.
enum class PlanStage { read, flatten, propose, propose_merges, pieces };

/// A message for the user.
struct PlanMessage {
    enum class Kind { information, note, warning } kind = Kind::information;
    std::string text;
};

/// Observes a long job. Each function may be empty. All are called on the caller's thread except `progress`, which may
/// be called on any thread, but never on two at once.
struct PlanWatch {
    std::function<void(PlanStage)> stage = {};  ///< called when the step begins
    Progress progress = {};                     ///< progress of the current step
    std::function<void(const EnvelopeInput&)> read = {};
    std::function<void(const PlanMessage&)> message = {};
};

/// An envelope flattened and judged, with its pieces.
struct Plan {
    CutPlan cut;
    PieceSet pieces;
    std::optional<Unchanged> folder = {};  ///< the files it was read from (`read_plan`)

    /// Whether the envelope can be made as drawn and, if it was inflated, flies as drawn.
    bool is_good() const;
};

/// From a file to a plan: reads, finds seams, remeshes, judges the input, flattens or corrects, proposes seams, makes
/// the pieces and judges their cut lines. Faults of the envelope are among the findings of the plan. The result does
/// not depend on the number of threads. Throws InputError for a file that cannot be read or holds no tile
/// (`read_input`), for an unknown method, and for `compensate` with a method that cannot cut for a strain.
Plan plan_envelope(const std::filesystem::path& file, const Job& job = {}, const PlanWatch& watch = {});

/// The same from an envelope in memory, in metres and with its seams. Names, layers and grain lines of a project are
/// ignored, because they refer to files.
Plan plan_envelope(Envelope envelope, const Job& job = {}, const PlanWatch& watch = {});

/// Writes the folder of a plan, all or nothing (`write_directory`). Returns warnings, which are in report.json too: a
/// PDF is left out if nobody could print it, because it has too many pages or the unit is wrong. Throws InputError if
/// the folder is not empty (without `force`) or cannot be written.
std::vector<std::string> write_plan(const std::filesystem::path& folder, const Plan& plan,
                                    const WriteOptions& options = {});

/// Reads the plan that `write_plan` wrote to a folder. Not restored: `Envelope` as drawn if it was remeshed, and the
/// state in flight (`CutPlan::inflated`). Throws InputError as `read_cut_plan` does.
Plan read_plan(const std::filesystem::path& folder);

/// Updates the folder of a plan that was read from it and inflated since: report.json, report.html, inflated/. All or
/// nothing. Throws InputError if another run has written the folder in the meantime.
void update_plan(const std::filesystem::path& folder, const Plan& plan, const WriteOptions& options = {});

}  // namespace ripstop
