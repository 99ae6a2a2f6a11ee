/// ripstop compare: flattens the same tiles by several methods.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "commands/commands.h"
#include "commands/known.h"
#include "help/progress_bar.h"
#include "help/tell.h"
#include "options/options.h"
#include "ripstop/base/error.h"
#include "ripstop/flatten/method.h"
#include "ripstop/io/mesh/mesh_file.h"
#include "ripstop/io/text/output_file.h"
#include "ripstop/pipeline/flatten/flatten_envelope.h"
#include "ripstop/report/page/comparison.h"

namespace ripstop::cli {
namespace {

constexpr std::size_t most_on_sheet = 24;  ///< maximum number of tiles; more would make a picture too large to open

struct CompareArguments {
    InputArguments input;
    std::vector<std::string> methods;
    std::filesystem::path sheet;
    int jobs = 1;
    bool json = false, force = false, quiet = false;
};

/// The requested methods, each once; all if none was requested.
std::vector<std::string> methods_of(const CompareArguments& given) {
    std::vector<std::string> names;
    for (const std::string& name : given.methods)
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    if (names.empty())
        for (const Method& method : methods()) names.emplace_back(method.name);
    return names;
}

/// Throws InputError early if the sheet could not be written later or would overwrite an input.
void require_free_sheet(const CompareArguments& given) {
    if (given.sheet.empty()) return;
    std::error_code unknown;
    const std::filesystem::path folder = given.sheet.has_parent_path() ? given.sheet.parent_path() : ".";
    if (!std::filesystem::is_directory(folder, unknown))
        throw InputError(given.sheet.string() + ": there is no folder " + folder.string() + "; make it first");
    if (std::filesystem::equivalent(given.sheet, given.input.file, unknown))
        throw InputError(given.sheet.string() + ": is the input itself; give the sheet another name");
    if (std::filesystem::exists(given.sheet, unknown) && !given.force)
        throw InputError(given.sheet.string() + ": exists; give another name, or --force to replace it");
}

void require_room(const CompareArguments& given, std::size_t tiles) {
    if (!given.sheet.empty() && tiles > most_on_sheet)
        throw InputError(given.input.file.string() + ": " + std::to_string(tiles) + " tiles do not fit on a sheet, " +
                         std::to_string(most_on_sheet) + " do; choose some with --tile");
}

ExitCode run(const CompareArguments& given) {
    const Job job = job_of(given.input);
    require_free_sheet(given);
    const EnvelopeInput found = read(given.input, job, given.quiet);
    const Envelope& envelope = found.envelope;
    for (const EnvelopeIssue& issue : found.issues) tell(fmt::format("Warning: {}\n", issue.message));
    tell_unused(found.unused);
    require_room(given, envelope.tiles.size());
    std::vector<CutPlan> plans;
    const std::vector<std::string> names = methods_of(given);
    const Progress bar = progress_bar(given.quiet);
    for (const std::string& method : names) {
        const auto done = static_cast<double>(plans.size()), all = static_cast<double>(names.size());
        FlattenOptions options{method, *job.fabric, *job.tolerances, given.jobs};
        if (bar)
            options.progress = [&](double fraction, const std::string& tile) {
                bar((done + fraction) / all, method + ", " + tile);
            };
        CutPlan plan = flatten_envelope(envelope, options);
        plan.input_file = given.input.file.filename().string();
        plan.input_sha256 = sha256_of_file(given.input.file);
        plan.unit = found.unit.unit.name;
        plan.remarks = found.remarks;
        plans.push_back(std::move(plan));
    }
    if (given.json)
        print("{}", comparison_json(plans));
    else
        show(comparison_table(plans));
    if (given.sheet.empty()) return manufacturable;
    replace_file(given.sheet, comparison_sheet(plans));
    if (!given.json) print("{}\n", given.sheet.string());
    return manufacturable;
}

}  // namespace

void add_compare(CLI::App& app) {
    auto given = std::make_shared<CompareArguments>();
    CLI::App* command =
        app.add_subcommand("compare", "Flatten the same tiles by every method: one table, one sheet of shapes");
    add_input_options(*command, given->input);
    add_remesh_option(*command, given->input);
    command->add_option("--method", given->methods, "Only this method; may be repeated (default: all)")
        ->group("Flattening")
        ->type_name("NAME")
        ->allow_extra_args(false)
        ->check(known_method());
    command
        ->add_option("--sheet", given->sheet,
                     "An SVG to write: all the flat shapes with their colour maps, of 24 tiles at most")
        ->type_name("FILE");
    command->add_flag("--force", given->force, "Replace the sheet if it exists");
    command
        ->add_option("-j,--jobs", given->jobs, "Threads; 0: one per core; more than one makes the seconds less exact")
        ->capture_default_str()
        ->type_name("N")
        ->check(within(0, 1024));
    command->add_flag("--json", given->json,
                      "Print JSON on stdout instead of the table: what report.json says of a tile, for each method");
    command->add_flag("--quiet", given->quiet, "No progress");
    command->footer(
        "Examples:\n"
        "  ripstop compare envelope.obj --tile G01P03 --fabric nylon\n"
        "  ripstop compare envelope.obj --tile G01P03 --method seam-exact --method paper\n"
        "  ripstop compare envelope.obj --tile G01P03 --sheet methods.svg\n\n"
        "Exit codes: 0 whatever the verdicts (it compares, `flatten` decides), 2 usage, 3 unusable input.");
    command->callback([given] {
        if (const ExitCode code = run(*given)) throw CLI::RuntimeError(code);
    });
}

}  // namespace ripstop::cli
