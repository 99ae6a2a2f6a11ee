#include "format_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "dxf_options.h"
#include "ripstop/base/units.h"
#include "ripstop/io/paper.h"

namespace ripstop::cli {

void add_format_options(CLI::App& command, FormatArguments& given, const char* dialect) {
    std::string known;
    for (const PieceFormat& format : piece_formats())
        known += fmt::format("\n{:<6}{}", format.name, format.description);
    command
        .add_option("--format,--formats", given.formats,
                    fmt::format("The cut files, several with commas ({}):{}", fmt::join(given.formats, ","), known))
        ->delimiter(',')
        ->group("Cut files");
    command
        .add_option("--paper", given.files.paper,
                    "PDF: roll (a page a piece), how wide the roll is (914mm), or sheets: a4 ... a0, letter, tabloid")
        ->capture_default_str()
        ->group("Cut files");
    command
        .add_option("--frame", given.frame,
                    "HPGL: length of a frame, for plotters that count to 32,767 (else HP-GL/2: all in one)")
        ->group("Cut files");
    add_dxf_options(command, given.files, dialect);
}

PieceFileOptions file_options(const FormatArguments& given) {
    for (const std::string& format : given.formats) piece_format_named(format);
    PieceFileOptions options = dxf_options(given.files);
    paper_named(options.paper);
    if (!given.frame.empty()) options.frame = parse_length(given.frame, "--frame");
    return options;
}

}  // namespace ripstop::cli
