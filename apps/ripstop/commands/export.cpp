/// ripstop export: writes the pieces of a cut plan as other cut files, without solving again.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "commands/commands.h"
#include "help/progress_bar.h"
#include "help/tell.h"
#include "options/format_options.h"
#include "options/piece_options.h"
#include "ripstop/base/error.h"
#include "ripstop/base/text/glob.h"
#include "ripstop/pattern/piece/count_patterns.h"
#include "ripstop/plan_folder/cut_files.h"
#include "ripstop/plan_folder/whole_directory.h"

namespace ripstop::cli {
namespace {

struct ExportArguments {
    std::filesystem::path plan, output;
    FormatArguments files{{"dxf"}};
    std::vector<std::string> tiles;
    bool force = false, quiet = false;
};

void keep_named(PieceSet& set, const std::vector<std::string>& globs) {
    const auto is_left_out = [&globs](const PatternPiece& piece) {
        return std::none_of(globs.begin(), globs.end(),
                            [&piece](const std::string& glob) { return glob_match(glob, piece.name); });
    };
    if (globs.empty()) return;
    std::erase_if(set.pieces, is_left_out);
    if (set.pieces.empty())
        throw InputError(
            fmt::format("no piece is called {}; tiles.csv of the plan has the names", fmt::join(globs, " or ")));
    count_patterns(set.pieces);
}

/// Names the folder after its contents: formats, dialect and paper.
std::string default_name(const FormatArguments& given) {
    const PieceFileOptions usual, &files = given.files;
    std::vector<std::string> words = given.formats;
    if (files.dialect != usual.dialect) {
        if (words == std::vector<std::string>{"dxf"}) words.clear();
        words.push_back(files.dialect);
    }
    if (!files.grain_axis.empty()) words.push_back("grain-" + files.grain_axis);
    if (files.paper != usual.paper) words.push_back(files.paper);
    return fmt::format("{}", fmt::join(words, "-"));
}

ExitCode run(ExportArguments given) {
    choose_formats(given.files, true);
    const PieceFileOptions files = file_options(given.files);
    if (given.output.empty()) given.output = given.plan / ("cut-" + default_name(given.files));
    PieceSet set = read_pieces_of(given.plan);
    require_writable(given.output, given.force);
    keep_named(set, given.tiles);
    std::vector<std::string> sheets;
    for (const PieceFormat& format : piece_formats()) sheets.push_back("envelope." + format.extension);
    std::vector<std::string_view> ours(sheets.begin(), sheets.end());
    ours.push_back("tiles");
    write_whole_directory(given.output, given.force, ours, [&](const std::filesystem::path& folder) {
        const Waiting waiting(fmt::format("Writing {}", fmt::join(given.files.formats, ", ")), given.quiet);
        write_cut_files(folder, set, given.files.formats, files);
    });
    if (!given.quiet) print("{} pieces: {}\n", set.pieces.size(), given.output.string());
    return warn_of_cut_lines(set);
}

}  // namespace

void add_export(CLI::App& app) {
    auto given = std::make_shared<ExportArguments>();
    CLI::App* command =
        app.add_subcommand("export", "Write the pieces of a cut plan in other formats, without flattening again");
    command->add_option("PLAN", given->plan, "A folder that `ripstop flatten` wrote")->type_name("DIR")->required();
    command->add_option("-o,--output", given->output, "The folder to write (default PLAN/cut-…, named by format)")
        ->type_name("DIR");
    add_format_options(*command, given->files, "--dialect");
    command
        ->add_option("--tile", given->tiles,
                     "Only pieces of this name; * and ? stand for other letters; may be repeated")
        ->type_name("NAME")
        ->allow_extra_args(false);
    command->add_flag("--force", given->force, "Replace the folder if it is not empty");
    command->add_flag("--quiet", given->quiet, "Print nothing unless something is wrong");
    command->footer(
        "Examples:\n"
        "  ripstop export cut-plan --dialect aama                     for garment CAD\n"
        "  ripstop export cut-plan --format pdf --paper a4            paper templates on sheets\n"
        "  ripstop export cut-plan --format hpgl --tile 'G01P*' -o gore-1\n\n"
        "Exit codes: 0 written, 1 written, but a cut line is wrong, 2 usage, 3 unusable input.");
    command->callback([given] {
        if (const ExitCode code = run(*given)) throw CLI::RuntimeError(code);
    });
}

}  // namespace ripstop::cli
