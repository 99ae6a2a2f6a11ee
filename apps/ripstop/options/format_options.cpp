#include "options/format_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "commands/known.h"
#include "options/dxf_options.h"
#include "ripstop/base/text/units.h"
#include "ripstop/io/print/paper.h"

namespace ripstop::cli {
namespace {

bool has(const std::vector<std::string>& formats, const std::string& name) {
    return std::find(formats.begin(), formats.end(), name) != formats.end();
}

}  // namespace

CLI::Option* add_format_option(CLI::App& command, std::vector<std::string>& formats) {
    std::string described;
    std::vector<std::string> names;
    for (const PieceFormat& format : piece_formats()) {
        names.push_back(format.name);
        described += fmt::format("\n{:<6}{}", format.name, format.description);
    }
    return command
        .add_option(
            "--format,--formats", formats,
            fmt::format("Formats to write, separated by commas (default {}):{}", fmt::join(formats, ","), described))
        ->type_name("FORMATS")
        ->delimiter(',')
        ->check(known([](const std::string& name) { piece_format_named(name); }, names));
}

void add_format_options(CLI::App& command, FormatArguments& given, const char* dialect) {
    given.format = add_format_option(command, given.formats)->group("Cut files");
    const CLI::Option* paper = command
                                   .add_option("--paper", given.files.paper,
                                               "Paper of the PDF: roll (one page per piece), the width of a roll "
                                               "(914mm), or sheets: a4 … a0, letter, tabloid")
                                   ->capture_default_str()
                                   ->type_name("PAPER")
                                   ->check(known([](const std::string& name) { paper_named(name); },
                                                 {"roll", "a4", "a3", "a2", "a1", "a0", "letter", "tabloid"}))
                                   ->group("Cut files");
    const CLI::Option* frame =
        command
            .add_option("--frame", given.frame,
                        "Frame length of the HPGL, such as 600mm, for plotters that count to 32,767 (default: one "
                        "frame, HP-GL/2)")
            ->type_name("LENGTH")
            ->group("Cut files");
    const DxfFlags dxf = add_dxf_options(command, given.files, dialect);
    given.meant = {{paper, {"pdf"}},
                   {frame, {"hpgl"}},
                   {dxf.dialect, {"dxf"}},
                   {dxf.grain_axis, {"dxf"}},
                   {dxf.date, {"dxf", "pdf"}}};
}

void choose_formats(FormatArguments& given, bool alone) {
    const bool is_asked = given.format->count() > 0;
    std::vector<std::string> chosen = alone && !is_asked ? std::vector<std::string>{} : given.formats;
    for (const auto& [option, formats] : given.meant) {
        const auto is_chosen = [&chosen](const std::string& format) { return has(chosen, format); };
        if (option->count() == 0 || std::any_of(formats.begin(), formats.end(), is_chosen)) continue;
        if (is_asked)
            throw CLI::ValidationError(fmt::format("{} does not apply to {}, only to {}; add that to --format",
                                                   option->get_name(), fmt::join(chosen, ","),
                                                   fmt::join(formats, " and ")));
        chosen.push_back(formats.front());
    }
    if (!chosen.empty()) given.formats = chosen;
}

PieceFileOptions file_options(const FormatArguments& given) {
    PieceFileOptions options = with_date(given.files);
    if (!given.frame.empty()) options.frame = parse_length(given.frame, "--frame");
    return options;
}

}  // namespace ripstop::cli
