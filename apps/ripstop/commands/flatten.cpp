/// ripstop flatten: an envelope in, every tile flattened and judged, a cut plan out.
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <utility>

#include "commands/commands.h"
#include "commands/known.h"
#include "help/progress_bar.h"
#include "help/tell.h"
#include "options/flight_options.h"
#include "options/format_options.h"
#include "options/options.h"
#include "options/piece_options.h"
#include "ripstop/base/error.h"
#include "ripstop/base/sha256.h"
#include "ripstop/io/mesh/mesh_file.h"
#include "ripstop/io/print/pdf.h"
#include "ripstop/pattern/cut/cut_check.h"
#include "ripstop/pipeline/flatten/flatten_envelope.h"
#include "ripstop/pipeline/flatten/strain_maps.h"
#include "ripstop/pipeline/flight/compensate.h"
#include "ripstop/pipeline/read/envelope_faults.h"
#include "ripstop/pipeline/read/own_meshes.h"
#include "ripstop/pipeline/redesign/propose_redesign.h"
#include "ripstop/plan_folder/cut_files.h"
#include "ripstop/plan_folder/directory.h"
#include "ripstop/report/figures/wide_pieces.h"
#include "ripstop/report/json/report_json.h"
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
    FormatArguments files{DirectoryOptions{}.formats};
    bool compensate = false;
    FlightArguments flight;
};

/// Where no unit was given, the size tells whether metres were the right guess.
void print_assumed_size(const Envelope& envelope) {
    Eigen::AlignedBox3d box;
    for (const Tile& tile : envelope.tiles)
        for (Eigen::Index v = 0; v < tile.mesh.positions.rows(); ++v) box.extend(Vec3(tile.mesh.positions.row(v)));
    const Vec3 size = box.sizes();
    tell(fmt::format(
        "No unit given: taken as metres, which makes the envelope {:.4g} x {:.4g} x {:.4g} m (--unit changes it)\n",
        size.x(), size.y(), size.z()));
}

/// What to draw instead. Nothing where the input was only judged: there is no method to try it with.
void propose(CutPlan& plan, const std::string& method, const FlattenArguments& given) {
    if (method == "given") return;
    constexpr int all = std::numeric_limits<int>::max();
    const Progress bar = progress_bar(given.quiet);
    if (given.propose == "auto" && !add_proposals(plan, method_named(method), given.jobs, {}, bar) && !given.quiet)
        tell("Too many tiles fail to propose seams for them unasked; --propose all tries every one\n");
    if (given.propose == "all") add_proposals(plan, method_named(method), given.jobs, {all, all}, bar);
    if (given.propose_merges)
        plan.merges = propose_merges(plan, method_named(method), given.jobs, progress_bar(given.quiet));
}

/// What is wrong with the envelope itself, as `ripstop check` says. What of it is meant is told.
void take_faults(CutPlan& plan, const EnvelopeCheck& check, bool quiet) {
    const std::size_t told = plan.remarks.size();
    add_faults(plan, check);
    for (std::size_t i = told; i < plan.remarks.size() && !quiet; ++i) tell(fmt::format("Note: {}\n", plan.remarks[i]));
}

/// Leaves the PDF out if it has more pages than anyone prints, or if the unit is wrong: then nobody prints it, and
/// writing its thousands of pages takes a minute. Returns a warning that says so.
std::vector<std::string> leave_out_unprintable(DirectoryOptions& writing, const PieceSet& pieces, bool unit_is_wrong) {
    const auto pdf = std::find(writing.formats.begin(), writing.formats.end(), "pdf");
    if (pdf == writing.formats.end()) return {};
    if (unit_is_wrong) {
        writing.formats.erase(pdf);
        return {"no PDF is written: the unit is wrong"};
    }
    try {
        require_printable(pieces.pieces, writing.files.paper);
    } catch (const InputError& error) {
        writing.formats.erase(pdf);
        return {"no PDF is written: " + std::string(error.what())};
    }
    return {};
}

/// On stderr and in the report.
void warn(DirectoryOptions& writing, const std::vector<std::string>& warnings, bool quiet) {
    for (const std::string& warning : warnings)
        if (!quiet) tell(fmt::format("Warning: {}\n", warning));
    writing.warnings.insert(writing.warnings.end(), warnings.begin(), warnings.end());
}

/// Of seams that fail only the worst have pictures.
void tell_unpictured(const CutPlan& plan) {
    const std::size_t pictured = pictured_seams(plan).size();
    const auto failing =
        std::count_if(plan.walks.begin(), plan.walks.end(), [](const SeamWalk& walk) { return !walk.ok; });
    if (std::cmp_less(pictured, failing))
        tell(fmt::format("Pictures of the {} worst of {} seams that fail; report.html shows them all\n", pictured,
                         failing));
}

/// Patterns that inflate to the drawn shape, and how they fly.
CutPlan compensated(const Envelope& envelope, FlattenOptions flattening, const Flight& flight, bool quiet) {
    if (!flattening.method.starts_with("seam-"))
        throw CLI::ValidationError("--compensate",
                                   "only the methods seam-… cut cloth for a strain, not " + flattening.method);
    CompensateOptions options{std::exchange(flattening, {}), {flight.load, flight.rigging}, flight.tapes};
    options.inflate.threads = options.flatten.threads;
    options.flatten.progress = {};
    options.progress = progress_bar(quiet);
    CutPlan plan = compensate(envelope, options);
    plan.flight = flight;
    return plan;
}

ExitCode run(FlattenArguments given) {
    choose_formats(given.files, false);
    if (given.compensate && !given.input.tiles.empty())
        throw CLI::ValidationError("--compensate", "only a whole envelope can be inflated; leave out --tile");
    const std::string method = method_of(given.input);
    PieceOptions pattern = piece_options(given.pieces);
    DirectoryOptions writing{given.force, given.reproducible};
    writing.png = given.pictures;
    writing.threads = given.jobs;
    writing.formats = given.files.formats;
    writing.files = file_options(given.files);
    require_writable(given.directory, given.force);
    const Input input = resolve(given.input);
    EnvelopeInput found = read(given.input, input, given.quiet);
    const Envelope& envelope = found.envelope;
    tell_unused(found.unused);
    writing.warnings = found.unused;
    if (found.doubt && !found.doubt->is_wrong) writing.warnings.push_back(found.doubt->sentence);
    if (found.unit_assumed && !given.quiet) print_assumed_size(envelope);

    const EnvelopeCheck faults = judge_envelope(given.input, input, found);
    FlattenOptions options{method, input.fabric, input.tolerances, given.jobs, progress_bar(given.quiet)};
    const Flight& flight = found.flight;
    CutPlan plan = given.compensate ? compensated(envelope, options, flight_of(given.flight, flight), given.quiet)
                                    : flatten_envelope(envelope, options);
    if (!given.compensate && input.read.remesh.mode == RemeshMode::automatic &&
        prefer_own_meshes(plan, found, options) && !given.quiet)
        tell(fmt::format("Note: {}\n", found.remarks.back()));
    if (!plan.flight && input.read.project) plan.flight = flight;
    plan.input_file = given.input.file.filename().string();
    plan.input_sha256 = sha256_of_file(given.input.file);
    plan.unit = found.unit.unit.name;
    plan.remarks = found.remarks;
    take_faults(plan, faults, given.quiet);
    propose(plan, method, given);

    if (pattern.revision.empty()) pattern.revision = plan.input_sha256.substr(0, 8);
    std::vector<PatternPiece> drawn = make_pieces(plan, pattern, given.jobs);
    warn(writing, judge_cut_lines(plan, drawn, given.pieces.allowance_fit, given.jobs), given.quiet);
    const PieceSet pieces = make_piece_set(plan, std::move(drawn), pattern.revision);
    warn(writing, too_wide_pieces(pieces), given.quiet);
    const bool unit_is_wrong = found.doubt && found.doubt->is_wrong;
    warn(writing, leave_out_unprintable(writing, pieces, unit_is_wrong), given.quiet);
    {
        const Waiting waiting("Writing " + given.directory.string(), given.quiet);
        write_directory(given.directory, plan, pieces, writing, measure_strain_maps(plan, given.jobs));
    }
    if (given.pictures && !given.quiet) tell_unpictured(plan);
    if (given.json)
        print("{}", report_json(plan, given.reproducible, writing.warnings));
    else if (!given.quiet)
        show(fmt::format("{}{}\n{}{}\n", tiles_table(plan), proposals_text(plan),
                         plan.inflated ? inflated_text(plan) + "\n" : "", given.directory.string()));
    return plan.manufacturable() && (!plan.inflated || flies_as_drawn(plan)) ? manufacturable : not_manufacturable;
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
    command->add_flag("--force", given->force, "Replace the folder where it is not empty");
    command->add_option("-j,--jobs", given->jobs, "Threads; 0 is one a core; the result is the same")
        ->capture_default_str()
        ->type_name("N")
        ->check(within(0, 1024));
    command->add_flag("--json", given->json, "Print report.json on stdout instead of the table");
    command->add_flag("--quiet", given->quiet, "No table, no progress");
    command->add_flag("--reproducible", given->reproducible, "Leave the seconds out of report.json");
    command->add_flag(
        "--pictures", given->pictures,
        "Also what report.html shows as PNG pictures, for e-mail and CI: the envelope in every colour "
        "map, the piece of each pattern (tiles cut alike share one), the 24 worst of the seams that fail");
    command
        ->add_option("--propose", given->propose,
                     "For tiles that cannot be made, try the seams that help: auto (where few kinds fail), all, none")
        ->capture_default_str()
        ->type_name("WORD")
        ->check(one_of({"auto", "all", "none"}))
        ->group("Flattening");
    command
        ->add_flag("--propose-merges", given->propose_merges,
                   "Try every two neighbours as one tile and list those that could be made; flattens once more a seam")
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
