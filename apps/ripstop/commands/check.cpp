/// ripstop check: reports what was read from an envelope, and its faults.
#include <fmt/format.h>

#include <utility>

#include "commands/commands.h"
#include "help/progress_bar.h"
#include "help/tell.h"
#include "options/options.h"
#include "ripstop/assembly/faults/check_envelope.h"
#include "ripstop/pipeline/read/seam_doubts.h"
#include "ripstop/report/words/check_report.h"

namespace ripstop::cli {
namespace {

struct CheckArguments {
    InputArguments input;
    bool json = false, quiet = false;
};

ExitCode run(const CheckArguments& given) {
    Job job = job_of(given.input);
    RemeshOptions remesh = std::exchange(job.read.remesh, {});  // only used to see which seams it would make certain
    remesh.seam_tolerance = job.read.seam_tolerance;
    const EnvelopeInput whole = read(given.input, job, given.quiet);
    EnvelopeCheck check = [&] {
        const Waiting waiting("Checking " + given.input.file.filename().string(), given.quiet);
        EnvelopeCheck found = judge_envelope(job, whole);
        add_seam_doubts(found, whole.envelope, remesh);
        return found;
    }();
    check.fabrics = count_fabrics(whole.envelope, *job.fabric);
    check.notes.insert(check.notes.end(), whole.unused.begin(), whole.unused.end());
    const std::string& unit = whole.unit.unit.name;
    const std::string file = given.input.file.filename().string();
    if (given.json)
        print("{}", check_json(check, file, unit));
    else if (!given.quiet)
        show(check_text(check, file, unit + (whole.unit_assumed ? " (assumed; --unit changes it)" : "")));
    return check.sound() ? manufacturable : not_manufacturable;
}

}  // namespace

void add_check(CLI::App& app) {
    auto given = std::make_shared<CheckArguments>();
    CLI::App* command = app.add_subcommand(
        "check", "Report what was read from an envelope and what is wrong with it; solves and writes nothing");
    add_input_options(*command, given->input);
    add_accept_option(*command, given->input);
    add_remesh_option(*command, given->input);
    command->add_flag("--json", given->json, "Print one JSON object on stdout instead of the text");
    command->add_flag("--quiet", given->quiet, "Print nothing; the exit code is the result");
    command->footer(
        "Examples:\n"
        "  ripstop check envelope.obj --unit m\n"
        "  ripstop check envelope.obj --unit m --seam-tolerance 1mm     edges drawn less exactly\n"
        "  ripstop check envelope.obj --unit m --accept missing_tile    its openings are intended\n"
        "  ripstop check envelope.obj --unit m --json                   for a script\n\n"
        "Exit codes: 0 sound, 1 something is wrong, 2 usage, 3 unusable input.");
    command->callback([given] {
        if (const ExitCode code = run(*given)) throw CLI::RuntimeError(code);
    });
}

}  // namespace ripstop::cli
