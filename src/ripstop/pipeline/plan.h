#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ripstop/base/progress.h"
#include "ripstop/io/piece_format.h"
#include "ripstop/model/flight/flight.h"
#include "ripstop/model/piece/pattern_piece.h"
#include "ripstop/model/plan/cut_plan.h"
#include "ripstop/pattern/piece/pieces.h"
#include "ripstop/pipeline/read/read_envelope.h"
#include "ripstop/plan_folder/unchanged.h"

/// The main job: from a drawn envelope to a plan, and from a plan to its folder and back.
namespace ripstop {

/// For which tiles that cannot be made a seam is tried.
enum class ProposeScope {
    none,
    automatic,  ///< all, unless they are of too many kinds (`ProposeLimits`)
    all
};

/// What `plan_envelope` is asked for. What is not said here the project says (`completed`).
struct Job {
    ReadOptions read = {.remesh = {.mode = RemeshMode::automatic}};
    std::string fabric_name = {};               ///< a preset or a file; empty: the project's, else isotropic
    std::optional<Fabric> fabric = {};          ///< instead of `fabric_name`
    std::optional<double> seam_tolerance = {};  ///< [m]; else the project's, else that of `read`
    std::optional<Tolerances> tolerances = {};  ///< else those of the fabric, changed by the project
    std::vector<std::string> accept = {};       ///< codes of issues that are meant, beside the project's
    std::string method = "seam-exact";          ///< as `FlattenOptions::method`
    bool compensate = false;                    ///< correct the patterns for their shape in flight (`compensate`)
    std::function<Flight(Flight)> flight = {};  ///< changes the project's flight; for `compensate`
    ProposeScope propose = ProposeScope::automatic;
    bool propose_merges = false;
    PieceOptions pieces = {};    ///< without a revision it is the start of the input's hash
    bool allowance_fit = false;  ///< as `judge_cut_lines`
    int threads = 0;             ///< 0: one a core
};

/// Returns the job with all that its project says, and with its fabric and tolerances. Where both say something, the
/// job goes first. Throws InputError for a fabric that is not known.
Job completed(Job job);

/// A step of the work.
enum class PlanStage { read, flatten, propose, propose_merges, pieces };

/// A sentence for the person who waits.
struct PlanMessage {
    enum class Kind { information, note, warning } kind = Kind::information;
    std::string text;
};

/// Follows a long job. Each of the functions may be empty; all are called on the caller's thread but `progress`, which
/// is called on one thread at a time.
struct PlanWatch {
    std::function<void(PlanStage)> stage = {};  ///< the step begins
    Progress progress = {};                     ///< of the step that runs
    std::function<void(const EnvelopeInput&)> read = {};
    std::function<void(const PlanMessage&)> message = {};
};

/// An envelope flattened and judged, with its pieces.
struct Plan {
    CutPlan cut;
    PieceSet pieces;
    bool unit_is_wrong = false;            ///< the unit of the file is certainly another one (`UnitDoubt`)
    std::optional<Unchanged> folder = {};  ///< the files it was read from (`read_plan`)

    /// The envelope can be made as drawn and, where it was inflated, flies as drawn.
    bool is_good() const;
};

/// From a file to a plan: reads, finds seams, remeshes, judges the input, flattens or corrects, proposes seams, makes
/// the pieces and judges their cut lines. What is wrong with the envelope is in the findings of the plan. The result
/// does not depend on the number of threads. Throws InputError for a file that cannot be read or holds no tile
/// (`read_input`), for an unknown method, and for `compensate` with a method that cannot cut for a strain.
Plan plan_envelope(const std::filesystem::path& file, const Job& job = {}, const PlanWatch& watch = {});

/// The same from an envelope in memory, in metres and with its seams. Names, layers and grain of a project are not
/// applied, because they belong to files.
Plan plan_envelope(Envelope envelope, const Job& job = {}, const PlanWatch& watch = {});

/// How `write_plan` writes.
struct WriteOptions {
    bool force = false;         ///< replace what stands in a folder that is not empty
    bool reproducible = false;  ///< leave `seconds` out of report.json: the same bytes on every run
    bool png = false;           ///< also write PNG pictures of what report.html shows
    int threads = 0;            ///< 0: one a core
    std::vector<std::string> formats = {"dxf", "svg", "pdf"};  ///< of the cut files: names of `piece_formats`
    PieceFileOptions files = {};                               ///< how they are written
};

/// Writes the folder of a plan, all or nothing (`write_directory`). Returns warnings: a PDF is left out where nobody
/// could print it, because it has too many pages or the unit is wrong. report.json has the warnings too. Throws
/// InputError where the folder is not empty (without `force`) or cannot be written.
std::vector<std::string> write_plan(const std::filesystem::path& folder, const Plan& plan,
                                    const WriteOptions& options = {});

/// Returns the plan that `write_plan` wrote to a folder. What is not kept: `Envelope` as drawn where it was remeshed,
/// and the state in flight (`CutPlan::inflated`). Throws InputError as `read_cut_plan`.
Plan read_plan(const std::filesystem::path& folder);

/// Updates the folder of a plan that was read from it and inflated since: report.json, report.html, inflated/. All or
/// nothing. Throws InputError where another run has written the folder meanwhile.
void update_plan(const std::filesystem::path& folder, const Plan& plan, const WriteOptions& options = {});

}  // namespace ripstop
