/// ripstop check: what was understood of an envelope, and what is wrong with it.
#include <fmt/format.h>

#include "commands.h"
#include "options.h"
#include "ripstop/assembly/check_envelope.h"
#include "ripstop/report/check_report.h"

namespace ripstop::cli {
namespace {

struct Arguments {
    InputArguments input;
    bool json = false, quiet = false;
};

ExitCode run(const Arguments& given) {
    const Input input = resolve(given.input);
    const auto [envelope, unit, unit_assumed, remarks, unused] = read(given.input, input, given.quiet);
    EnvelopeCheck check = check_envelope(envelope, {input.read.seam_tolerance}, unit.metres);
    check.fabrics = count_fabrics(envelope, input.fabric);
    check.notes.insert(check.notes.end(), unused.begin(), unused.end());
    const std::string file = given.input.file.filename().string();
    if (given.json)
        fmt::print("{}", check_json(check, file, unit.name));
    else if (!given.quiet)
        fmt::print("{}", check_text(check, file, unit.name + (unit_assumed ? " (assumed; --unit changes it)" : "")));
    return check.sound() ? manufacturable : not_manufacturable;
}

}  // namespace

void add_check(CLI::App& app) {
    auto given = std::make_shared<Arguments>();
    CLI::App* command = app.add_subcommand("check", "Say what was understood of the input and what is wrong with it");
    add_input_options(*command, given->input);
    command->add_flag("--json", given->json, "Print one JSON object on stdout instead of the text");
    command->add_flag("--quiet", given->quiet, "Print nothing; the exit code tells");
    command->footer(
        "Exit codes: 0 sound, 1 something is wrong, 3 unusable input.\n"
        "Example: ripstop check envelope.obj --unit mm --seam-tolerance 1mm");
    command->callback([given] {
        if (const ExitCode code = run(*given)) throw CLI::RuntimeError(code);
    });
}

}  // namespace ripstop::cli
