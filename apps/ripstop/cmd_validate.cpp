/// ripstop validate: is a pattern file, anyone's, sound.
#include <fmt/format.h>

#include <filesystem>

#include "commands.h"
#include "ripstop/base/error.h"
#include "ripstop/io/pattern_file.h"
#include "ripstop/pattern/check_drawing.h"
#include "ripstop/report/drawing_report.h"

namespace ripstop::cli {
namespace {

struct Arguments {
    std::filesystem::path file;
    std::string unit, roll;
    bool json = false, quiet = false;
};

ExitCode run(const Arguments& given) {
    DrawingCheckOptions options;
    if (!given.unit.empty()) options.unit = {given.unit, metres_per_unit(given.unit)};
    if (!given.roll.empty()) options.roll = parse_length(given.roll, "--roll");
    if (options.roll && !(*options.roll > 0)) throw InputError("--roll " + given.roll + ": expected more than nothing");
    const DrawingCheck check = check_drawing(read_pattern_file(given.file), options);
    const std::string file = given.file.filename().string();
    if (given.json)
        fmt::print("{}", drawing_json(check, file));
    else if (!given.quiet)
        fmt::print("{}", drawing_text(check, file));
    return check.sound() ? manufacturable : not_manufacturable;
}

}  // namespace

void add_validate(CLI::App& app) {
    auto given = std::make_shared<Arguments>();
    CLI::App* command = app.add_subcommand(
        "validate", "Say whether a pattern file (DXF, SVG; anyone's) is sound: unit, contours, layers, sizes");
    command->add_option("FILE", given->file, "The file, .dxf or .svg")->required();
    command->add_option("--unit", given->unit, "Of the file's numbers, where it does not say: mm, cm, m, in, ft");
    command->add_option("--roll", given->roll, "Width of the cloth that every piece has to fit on, such as 1.5m");
    command->add_flag("--json", given->json, "Print one JSON object on stdout instead of the text");
    command->add_flag("--quiet", given->quiet, "Print nothing; the exit code tells");
    command->footer(
        "Exit codes: 0 sound, 1 something is wrong, 3 unreadable.\n"
        "Example: ripstop validate pattern.dxf --roll 1.5m");
    command->callback([given] {
        if (const ExitCode code = run(*given)) throw CLI::RuntimeError(code);
    });
}

}  // namespace ripstop::cli
