/// ripstop validate: checks a pattern file from any source.
#include <fmt/format.h>

#include <filesystem>

#include "commands/commands.h"
#include "help/progress_bar.h"
#include "help/tell.h"
#include "options/options.h"
#include "ripstop/base/error.h"
#include "ripstop/io/pattern_file.h"
#include "ripstop/pattern/drawing/check_drawing.h"
#include "ripstop/report/words/drawing_report.h"

namespace ripstop::cli {
namespace {

struct ValidateArguments {
    std::filesystem::path file;
    std::string unit, roll;
    bool json = false, quiet = false;
};

ExitCode run(const ValidateArguments& given) {
    DrawingCheckOptions options;
    if (!given.unit.empty()) options.unit = {given.unit, metres_per_unit(given.unit)};
    if (!given.roll.empty()) options.roll = parse_length(given.roll, "--roll");
    if (options.roll && !(*options.roll > 0))
        throw InputError("--roll is " + given.roll + ", expected a length above 0, such as 1.5m");
    const DrawingCheck check = [&] {
        const Waiting waiting("Reading " + given.file.filename().string(), given.quiet);
        return check_drawing(read_pattern_file(given.file), options);
    }();
    const std::string file = given.file.filename().string();
    if (given.json)
        print("{}", drawing_json(check, file));
    else if (!given.quiet)
        show(drawing_text(check, file));
    return check.sound() ? manufacturable : not_manufacturable;
}

}  // namespace

void add_validate(CLI::App& app) {
    auto given = std::make_shared<ValidateArguments>();
    CLI::App* command =
        app.add_subcommand("validate", "Check a pattern file of any program: unit, contours, layers, sizes");
    command->add_option("FILE", given->file, "The file, .dxf or .svg")->type_name("FILE")->required();
    command->add_option("--unit", given->unit, "Unit of the file's numbers, if it states none")
        ->type_name("UNIT")
        ->check(known_unit());
    command
        ->add_option("--roll", given->roll,
                     "Width of the cloth that every piece must fit on, such as 1.5m (default: not checked)")
        ->type_name("LENGTH");
    command->add_flag("--json", given->json, "Print one JSON object on stdout instead of the text");
    command->add_flag("--quiet", given->quiet, "Print nothing; the exit code is the result");
    command->footer(
        "Examples:\n"
        "  ripstop validate cut-plan/cut/envelope.dxf --roll 1.5m\n"
        "  ripstop validate cut-plan/cut/tiles/G01P03.svg\n"
        "  ripstop validate cut-plan/cut/envelope.dxf --json          for a script\n\n"
        "Exit codes: 0 sound, 1 something is wrong, 2 usage, 3 unreadable.");
    command->callback([given] {
        if (const ExitCode code = run(*given)) throw CLI::RuntimeError(code);
    });
}

}  // namespace ripstop::cli
