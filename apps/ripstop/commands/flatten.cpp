/// ripstop flatten: flattens and judges every tile of an envelope and writes a cut plan.
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <optional>
#include <utility>

#include "commands/commands.h"
#include "commands/known.h"
#include "help/progress_bar.h"
#include "help/tell.h"
#include "options/flight_options.h"
#include "options/format_options.h"
#include "options/options.h"
#include "options/piece_options.h"
#include "ripstop/pipeline/plan.h"
#include "ripstop/plan_folder/directory.h"
#include "ripstop/plan_folder/update_folder.h"
#include "ripstop/plan_folder/whole_directory.h"
#include "ripstop/report/picture/png_pictures.h"
#include "ripstop/report/tables/tables.h"
#include "ripstop/report/words/inflated_text.h"
#include "ripstop/report/words/proposals.h"

namespace ripstop::cli {
namespace {

struct FlattenArguments {
    InputArguments input;
    std::filesystem::path directory;
    int jobs = 0;
    bool force = false, json = false, quiet = false, reproducible = false, pictures = false;
    std::string propose = "auto";
    bool propose_merges = false;
    PieceArguments pieces;
    FormatArguments files{WriteOptions{}.formats};
    bool compensate = false;
    FlightArguments flight;
};

/// Prints the size if no unit was given, so the user sees whether metres were the right guess.
void print_assumed_size(const Envelope& envelope) {
    Eigen::AlignedBox3d box;
    for (const Tile& tile : envelope.tiles)
        for (Eigen::Index v = 0; v < tile.mesh.positions.rows(); ++v) box.extend(Vec3(tile.mesh.positions.row(v)));
    const Vec3 size = box.sizes();
    tell(fmt::format(
        "No unit given, so metres are assumed: the envelope measures {:.4g} x {:.4g} x {:.4g} m (--unit changes it)\n",
        size.x(), size.y(), size.z()));
}

/// Reports that only the worst failing seams have pictures.
void tell_unpictured(const CutPlan& plan) {
    const std::size_t pictured = pictured_seams(plan).size();
    const auto failing =
        std::count_if(plan.walks.begin(), plan.walks.end(), [](const SeamWalk& walk) { return !walk.ok; });
    if (std::cmp_less(pictured, failing))
        tell(fmt::format("Pictures of the {} worst of {} seams that fail; report.html shows them all\n", pictured,
                         failing));
}

const char* word_of(PlanMessage::Kind kind) {
    switch (kind) {
        case PlanMessage::Kind::note:
            return "Note: ";
        case PlanMessage::Kind::warning:
            return "Warning: ";
        default:
            return "";
    }
}

/// Shows the steps of `plan_envelope` on stderr.
class Teller {
  public:
    Teller(const FlattenArguments& given) : given_(given) {}

    PlanWatch watch() {
        PlanWatch watch;
        watch.stage = [this](PlanStage stage) { begin(stage); };
        watch.progress = [this](double fraction, const std::string& what) {
            if (progress_) progress_(fraction, what);
        };
        watch.read = [this](const EnvelopeInput& input) { tell_input(input); };
        watch.message = [this](const PlanMessage& message) {
            if (!given_.quiet) tell(fmt::format("{}{}\n", word_of(message.kind), message.text));
        };
        return watch;
    }

  private:
    void begin(PlanStage stage) {
        reading_.reset();
        progress_ = {};
        if (stage == PlanStage::read) {
            reading_.emplace("Reading " + given_.input.file.filename().string(), given_.quiet);
            progress_ = reading_->progress();
        } else if (stage != PlanStage::pieces) {
            progress_ = progress_bar(given_.quiet);
        }
    }

    void tell_input(const EnvelopeInput& input) {
        reading_.reset();
        if (!given_.quiet) tell_remarks(input);
        tell_unused(input.unused);
        if (input.unit_assumed && !given_.quiet) print_assumed_size(input.envelope);
    }

    const FlattenArguments& given_;
    std::optional<Waiting> reading_;
    Progress progress_;
};

Job flatten_job(const FlattenArguments& given) {
    Job job = job_of(given.input);
    job.method = method_of(given.input);
    if (given.compensate && !job.method.starts_with("seam-"))
        throw CLI::ValidationError("--compensate", "only the methods seam-… compensate for strain, not " + job.method);
    job.compensate = given.compensate;
    job.flight = [&given](const Flight& flight) { return flight_of(given.flight, flight); };
    job.propose = given.propose == "all"    ? ProposeScope::all
                  : given.propose == "none" ? ProposeScope::none
                                            : ProposeScope::automatic;
    job.propose_merges = given.propose_merges;
    job.pieces = piece_options(given.pieces);
    job.allowance_fit = given.pieces.allowance_fit;
    job.threads = given.jobs;
    return job;
}

WriteOptions write_options(const FlattenArguments& given) {
    WriteOptions options;
    options.force = given.force;
    options.reproducible = given.reproducible;
    options.png = given.pictures;
    options.threads = given.jobs;
    options.formats = given.files.formats;
    options.files = file_options(given.files);
    return options;
}

ExitCode run(FlattenArguments given) {
    choose_formats(given.files, false);
    if (given.compensate && !given.input.tiles.empty())
        throw CLI::ValidationError("--compensate", "only a whole envelope can be inflated; leave out --tile");
    const WriteOptions writing = write_options(given);
    const Job job = flatten_job(given);
    require_writable(given.directory, given.force);
    Teller teller(given);
    const Plan plan = plan_envelope(given.input.file, job, teller.watch());
    std::vector<std::string> warnings;
    {
        const Waiting waiting("Writing " + given.directory.string(), given.quiet);
        warnings = write_plan(given.directory, plan, writing);
    }
    for (const std::string& warning : warnings)
        if (!given.quiet) tell(fmt::format("Warning: {}\n", warning));
    if (given.pictures && !given.quiet) tell_unpictured(plan.cut);
    if (given.json)
        print("{}", report_of(given.directory));
    else if (!given.quiet)
        show(fmt::format("{}{}\n{}{}\n", tiles_table(plan.cut), proposals_text(plan.cut),
                         plan.cut.inflated ? inflated_text(plan.cut) + "\n" : "", given.directory.string()));
    return plan.is_good() ? manufacturable : not_manufacturable;
}

}  // namespace

void add_flatten(CLI::App& app) {
    auto given = std::make_shared<FlattenArguments>();
    CLI::App* command = app.add_subcommand("flatten", "Flatten every tile, judge it, write the cut plan");
    add_input_options(*command, given->input);
    add_accept_option(*command, given->input);
    add_method_option(*command, given->input);
    add_remesh_option(*command, given->input);
    command
        ->add_flag("--fair-seams", given->input.fair_seams,
                   "Cut along a fair curve, the same on both sides, where an edge zigzags along its mesh")
        ->group("Flattening");
    command->add_option("-o,--output", given->directory, "The folder to write; must not exist or be empty")
        ->type_name("DIR")
        ->required();
    command->add_flag("--force", given->force, "Replace the folder if it is not empty");
    command->add_option("-j,--jobs", given->jobs, "Threads, without effect on the result; 0: one per core")
        ->capture_default_str()
        ->type_name("N")
        ->check(within(0, 1024));
    command->add_flag("--json", given->json, "Print report.json on stdout instead of the table");
    command->add_flag("--quiet", given->quiet, "No table, no progress");
    command->add_flag("--reproducible", given->reproducible, "Leave the seconds out of report.json");
    command->add_flag(
        "--pictures", given->pictures,
        "Also write PNG pictures of what report.html shows, for e-mail and CI: the envelope in every colour "
        "map, the piece of each pattern (tiles cut alike share one), the 24 worst of the seams that fail");
    command
        ->add_option("--propose", given->propose,
                     "Try seams that would help tiles that cannot be made: auto (if few kinds fail), all, none")
        ->capture_default_str()
        ->type_name("WORD")
        ->check(one_of({"auto", "all", "none"}))
        ->group("Flattening");
    command
        ->add_flag("--propose-merges", given->propose_merges,
                   "Try every two neighbours as one tile and list those that could be made; one flattening per seam")
        ->group("Flattening");
    command
        ->add_flag("--compensate", given->compensate,
                   "Correct the patterns until they take the drawn shape when they are sewn and inflated; see "
                   "`ripstop inflate --help`")
        ->group("Flight");
    add_flight_options(*command, given->flight);
    add_piece_options(*command, given->pieces);
    add_format_options(*command, given->files, "--dxf-dialect");
    command->footer(
        "Examples:\n"
        "  ripstop flatten envelope.obj --unit m --fabric nylon -o cut-plan\n"
        "  ripstop flatten envelope.obj --unit m --tile 'G01P*' -o gore-1      some tiles only\n"
        "  ripstop flatten envelope.obj --unit m --project shop.json -o plan   with what a file cannot say\n"
        "  ripstop flatten envelope.obj --fabric nylon --compensate -o corrected   for the shape in "
        "flight\n\n"
        "Exit codes: 0 all manufacturable, 1 some not (all files written), 2 usage, 3 unusable input.");
    command->callback([given] {
        if (const ExitCode code = run(*given)) throw CLI::RuntimeError(code);
    });
}

}  // namespace ripstop::cli
